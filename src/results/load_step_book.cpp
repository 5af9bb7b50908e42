#include "results/load_step_book.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/components.hpp"
#include "joints/friction_work.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "results/turning_supports.hpp"

namespace voussoir {
namespace {

template <int dim>
using Tangential = std::array<double, dim - 1>;

template <int dim>
Tangential<dim> tangential(const PointField& field, int k) {
  Tangential<dim> t;
  for (int c = 1; c < dim; ++c) t[c - 1] = field[dim * k + c];
  return t;
}

/// Largest friction [N], without cohesion.
double rubbing(const Model& model, const ContactState& state, int k) {
  const int dim = model.components();
  const double friction = model.law()[k].friction;
  return std::isfinite(friction) ? friction * std::max(0.0, state.lambda[dim * k]) : 0.0;
}

}  // namespace

void add_work(const WorkOfForces& forces, double beyond_mean, double overshoot, bool jumped, EnergyOfStep& energy) {
  const double either_way = (std::abs(forces.change_of_loads) + std::abs(forces.change_of_reactions)) / 2;
  if (beyond_mean < (jumped ? 0.0 : -either_way - overshoot)) energy.jump = -beyond_mean;
  const bool is_way = !(energy.jump > 0 || beyond_mean < -either_way);
  energy.work_within_steps = is_way ? std::min(beyond_mean, either_way + overshoot) : 0.0;
  energy.external_work = forces.of_mean + energy.work_within_steps;
}

LoadStepBook::LoadStepBook(const Model& model, const AdaptiveStep& step, const ContactState& before,
                           const std::vector<double>& load_before, std::vector<double> let_go, bool from_motion)
    : model_(model),
      step_(step),
      before_(before),
      load_before_(load_before),
      let_go_(std::move(let_go)),
      from_motion_(from_motion),
      reaction_before_(step.residual(before, load_before)),
      gap_before_(step.stone_gaps(before)) {
  VOUSSOIR_EXPECT((let_go_.empty() || is_of_nodes(model, let_go_)) && "forces let go: of node copies, or none");
}

/// What strength takes along the law's own way, and what the mean of forces leaves out of it.
CrackWork LoadStepBook::add_fracture(const ContactState& after, const PointField& gap, int k, OfPoints& sum) const {
  const int dim = model_.components();
  const auto& law = model_.law()[k];
  const auto& softening = model_.softening()[k];
  const auto end_of = [&](const ContactState& state, const PointField& gaps) {
    CrackEnd end{{state.opened[k], state.slipped[k]}, gaps[dim * k], state.lambda[dim * k]};
    // Of a point that bears what its law has no open one bear, the gap is what solvers leave of none.
    const double pull = weaken(law, softening, end.wear, end.gap, 0).pull;
    if (!(model_.local_stiffness()[k] * end.gap - end.normal > pull)) end.gap = std::min(end.gap, 0.0);
    return end;
  };
  const auto from = end_of(before_, gap_before_), to = end_of(after, gap);
  const auto work = crack_work(law, softening, from, to);
  sum.held += held_energy(law, softening, to.wear, to.gap);
  sum.fracture += work.fracture;
  const double pulled = std::max(0.0, -from.normal), pulls = std::max(0.0, -to.normal);
  sum.beyond_mean += work.pull - (pulled + pulls) / 2 * (std::max(0.0, to.gap) - std::max(0.0, from.gap));
  sum.overshoot += std::max(0.0, work.peak_pull - std::max(pulled, pulls)) * work.opened;
  return work;
}

/// Friction takes the force at the end of the step; work has that of the mean of bounds.
template <int dim>
void LoadStepBook::add_friction(const ContactState& after, const PointField& gap, const CrackWork& crack, int k,
                                OfPoints& sum) const {
  const auto force_before = tangential<dim>(before_.lambda, k), force = tangential<dim>(after.lambda, k);
  const auto slip = tangential<dim>(gap, k) - tangential<dim>(gap_before_, k);
  const auto law = law_left(model_, after, k), law_before = law_left(model_, before_, k);
  const double bound = friction_bound(law, after.lambda[dim * k]);
  const double all = friction_work(bound, force, slip, model_.local_stiffness()[k]);
  if (all == 0 && crack.slipped == 0) return;
  const bool softens = !model_.softening().empty() && model_.softening()[k].any();
  const double way = norm(slip), taken = all - (softens ? std::min(all, law.cohesion * way) : 0.0);
  const double rubbed = softens ? rubbing(model_, before_, k) : friction_bound(law_before, before_.lambda[dim * k]);
  sum.friction += taken;
  sum.beyond_mean += crack.cohesion + (rubbed * way + taken) / 2 + 0.5 * dot(force_before + force, slip);
  const double peak = std::max(friction_bound(law_before, std::max(0.0, before_.lambda[dim * k])),
                               friction_bound(law_before, std::max(0.0, after.lambda[dim * k])));
  if (std::isfinite(peak))
    sum.overshoot += std::max(0.0, peak - std::max(norm(force_before), norm(force))) * std::max(way, crack.slipped);
}

LoadStepBook::OfPoints LoadStepBook::of_points(const ContactState& after) const {
  OfPoints sum;
  const auto gap = step_.stone_gaps(after);
  for (int k = 0; k < model_.points().owned(); ++k) {
    if (!after.selected[k] || !model_.bears(k)) continue;
    const bool softens = !model_.softening().empty() && model_.softening()[k].any();
    const auto crack = softens ? add_fracture(after, gap, k, sum) : CrackWork{};
    with_components(model_.components(), [&](auto dim) { add_friction<dim>(after, gap, crack, k, sum); });
  }
  return sum;
}

EnergyOfStep LoadStepBook::close(const ContactState& after, const std::vector<double>& load, bool jumped) const {
  expect_state(model_, after);
  VOUSSOIR_EXPECT(is_of_nodes(model_, load) && "load: of node copies");
  const auto& s = model_.structure();
  const int dim = model_.components();
  const auto reaction = step_.residual(after, load);
  const auto deformation = s.deformation(after.displacement);
  std::vector<double> ku;
  s.apply_stiffness(deformation, ku);
  EnergyOfStep energy;
  WorkOfForces work;
  work.of_mean = beyond_the_chord(model_, before_, after, reaction_before_, reaction);
  std::vector<double> moved(after.displacement.size());
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = after.displacement[i] - before_.displacement[i];
  const auto held = model_.held().held_part(moved, dim);
  for (int i = 0; i < dim * s.owned_nodes(); ++i) {
    const auto& absent = model_.absent();
    if (absent.empty() || !absent[s.block_of_node()[i / dim]]) energy.elastic += deformation[i] * ku[i] / 2;
    work.of_mean += moved[i] * (load_before_[i] + load[i]) / 2;
    work.of_mean += held[i] * (reaction_before_[i] + reaction[i]) / 2;
    work.change_of_loads += (moved[i] - held[i]) * (load[i] - load_before_[i] - (let_go_.empty() ? 0.0 : let_go_[i]));
    work.change_of_reactions += held[i] * (reaction[i] - reaction_before_[i]);
    if (from_motion_) energy.removed -= (moved[i] - held[i]) * reaction_before_[i] / 2;
  }
  const auto points = of_points(after);
  energy.elastic += model_.mortar_energy(after.lambda) + points.held;
  const auto& comm = *s.comm();
  const auto all = [&comm](double mine) { return total_over_ranks(comm, mine); };
  const WorkOfForces of_all{all(work.of_mean), all(work.change_of_loads), all(work.change_of_reactions)};
  energy.elastic = all(energy.elastic);
  energy.removed = all(energy.removed);
  energy.friction = all(points.friction);
  energy.fracture = all(points.fracture);
  add_work(of_all, all(points.beyond_mean), all(points.overshoot), jumped, energy);
  VOUSSOIR_ENSURE(!(energy.fracture < 0) && !(energy.friction < 0) && !(energy.jump < 0));
  return energy;
}

}  // namespace voussoir
