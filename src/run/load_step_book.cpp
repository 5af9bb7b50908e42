#include "run/load_step_book.hpp"

#include <algorithm>
#include <cmath>

#include "joints/friction_work.hpp"
#include "linalg/reduce.hpp"
#include "step/joint_strength.hpp"

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
template <int dim>
double rubbing(const Model<dim>& model, const ContactState& state, int k) {
  const double friction = model.law()[k].friction;
  return std::isfinite(friction) ? friction * std::max(0.0, state.lambda[dim * k]) : 0.0;
}

}  // namespace

template <int dim>
LoadStepBook<dim>::LoadStepBook(const Model<dim>& model, const AdaptiveStep<dim>& step, const ContactState& before,
                                const std::vector<double>& load_before)
    : model_(model),
      step_(step),
      before_(before),
      load_before_(load_before),
      reaction_before_(step.residual(before, load_before)),
      gap_before_(step.stone_gaps(before)) {}

/// What strength takes in opening and in slipping, exact on a straight way; what joints would give back is no loss.
template <int dim>
void LoadStepBook<dim>::add_fracture(const ContactState& after, const PointField& gap, int k, OfPoints& sum) const {
  const auto& law = model_.law()[k];
  const auto& softening = model_.softening()[k];
  const JointWear start{before_.opened[k], before_.slipped[k]}, end{after.opened[k], after.slipped[k]};
  const double held_before = held_energy(law, softening, start, gap_before_[dim * k]);
  const double held_after = held_energy(law, softening, end, gap[dim * k]);
  sum.held += held_after;
  const double mean = mean_strength(softening, start, end);
  const auto taken = [mean](double strength, double way) { return way > 0 ? mean * strength * way : 0.0; };
  const double opened = std::max(0.0, gap[dim * k]) - std::max(0.0, gap_before_[dim * k]);
  const double pulled = std::min(0.0, before_.lambda[dim * k]) + std::min(0.0, after.lambda[dim * k]);
  double work = -pulled / 2 * opened;
  if (end.opened > start.opened) {  // it pulls as before up to the largest opening there has been, then it softens
    const double exact =
        held_energy(law, softening, start, start.opened) - held_before + taken(law.tension, end.opened - start.opened);
    sum.to_work += exact - work;
    work = exact;
  }
  if (const double way = end.slipped - start.slipped; way > 0) {
    const double exact = taken(law.cohesion, way);
    const double ends = law_left(model_, before_, k).cohesion + law_left(model_, after, k).cohesion;
    sum.to_work += exact - ends / 2 * way;
    work += exact;
  }
  sum.fracture += work - (held_after - held_before);
}

template <int dim>
typename LoadStepBook<dim>::OfPoints LoadStepBook<dim>::of_points(const ContactState& after) const {
  OfPoints sum;
  const auto gap = step_.stone_gaps(after);
  for (int k = 0; k < model_.points().owned(); ++k) {
    if (!after.selected[k]) continue;
    if (!model_.softening().empty()) add_fracture(after, gap, k, sum);
    const auto force_before = tangential<dim>(before_.lambda, k), force = tangential<dim>(after.lambda, k);
    const auto slip = tangential<dim>(gap, k) - tangential<dim>(gap_before_, k);
    const auto law = law_left(model_, after, k);
    const double bound = friction_bound(law, after.lambda[dim * k]);
    const double all = friction_work(bound, force, slip, model_.local_stiffness()[k]);
    if (all == 0) continue;
    const double by_cohesion = std::min(all, law.cohesion * norm(slip)), taken = all - by_cohesion;
    const double cohesion = law_left(model_, before_, k).cohesion + law.cohesion;
    const double by_mean = -0.5 * dot(force_before + force, slip);
    const double by_bounds = ((rubbing(model_, before_, k) + cohesion) * norm(slip) + taken) / 2;
    sum.friction += taken;
    sum.to_work += by_bounds - by_mean;
  }
  return sum;
}

template <int dim>
EnergyOfStep LoadStepBook<dim>::close(const ContactState& after, const std::vector<double>& load) const {
  const auto& s = model_.structure();
  const auto reaction = step_.residual(after, load);
  const auto deformation = s.deformation(after.displacement);
  std::vector<double> ku;
  s.apply_stiffness(deformation, ku);
  double elastic = 0, work = 0;
  for (int i = 0; i < dim * s.owned_nodes(); ++i) {
    elastic += deformation[i] * ku[i] / 2;
    const double moved = after.displacement[i] - before_.displacement[i];
    work += moved * (load_before_[i] + load[i]) / 2;
    if (model_.held()[i]) work += moved * (reaction_before_[i] + reaction[i]) / 2;
  }
  const auto points = of_points(after);
  elastic += model_.mortar_energy(after.lambda) + points.held;
  const auto& comm = *s.comm();
  return {total_over_ranks(comm, elastic),
          0,
          total_over_ranks(comm, work + points.to_work),
          total_over_ranks(comm, points.friction),
          total_over_ranks(comm, points.fracture),
          0};
}

template class LoadStepBook<2>;

}  // namespace voussoir
