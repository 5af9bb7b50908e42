#include "time/dynamic_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "joints/friction_work.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/mortar.hpp"
#include "model/phase.hpp"
#include "model/point_status.hpp"
#include "step/release.hpp"
#include "ties/error_estimate.hpp"

namespace voussoir {

DynamicStep::DynamicStep(const Model& at_rest, std::shared_ptr<Progress> progress)
    : at_rest_(at_rest), mass_(at_rest.mass()), velocities_(at_rest, *mass_), progress_(std::move(progress)) {
  const int dim = at_rest_.components();
  rule_.mass_damping = at_rest.settings().time.mass_damping;
  rule_.stiffness_damping = at_rest.settings().time.stiffness_damping;
  std::vector<double> along_x(static_cast<std::size_t>(dim) * mass_->nodes(), 0.0), momentum;
  const auto& absent = at_rest.absent();
  for (std::size_t i = 0; i < along_x.size(); i += dim)
    along_x[i] = absent.empty() || !absent[mass_->block_of_node()[i / dim]];
  total_mass_ = 2 * velocities_.kinetic_energy(along_x);
  mass_->apply_stiffness(along_x, momentum);
  for (std::size_t i = 0; i < momentum.size(); i += dim) mass_of_node_.push_back(momentum[i]);
}

double DynamicStep::total(double mine) const { return total_over_ranks(*mass_->comm(), mine); }

double DynamicStep::crossing_time() const {
  double longest = 0;
  for (int b = 0; b < mass_->local_blocks(); ++b) longest = std::max(longest, mass_->size() / at_rest_.wave_speed(b));
  return largest_over_ranks(*mass_->comm(), longest);
}

double DynamicStep::courant_time() const {
  double shortest = std::numeric_limits<double>::max();
  for (int b = 0; b < mass_->local_blocks(); ++b) shortest = std::min(shortest, at_rest_.passage(b));
  return least_over_ranks(*mass_->comm(), shortest);
}

void DynamicStep::set_time_step(double time_step) {
  VOUSSOIR_EXPECT(time_step > 0 && std::isfinite(time_step) && "time step: positive");
  if (model_ && rule_.time_step == time_step) return;
  rule_.time_step = time_step;
  const double tolerance = std::min(at_rest_.settings().time.force_tolerance, at_rest_.settings().newton.tolerance);
  step_.reset();
  velocities_.forget();
  model_ = at_rest_.of_time_step(*mass_, rule_, tolerance);
  step_ = std::make_unique<AdaptiveStep>(*model_, progress_);
}

/// The gaps that the points of the time step have at w = 0: none where points are closed, which is so up to round-off,
/// or up to what load steps leave between points that press. Mortar is a spring, whose force is that of the middle: its
/// gap counts whole, so that there it is what the displacements make it. So does one beside a stone that is not there.
void DynamicStep::offset_gaps(const PointField& gap, const PointField& lambda) {
  const int dim = at_rest_.components();
  const double round_off = closed_gap * at_rest_.structure().size();
  const double left = at_rest_.settings().internals.step.noise * at_rest_.settings().newton.tolerance *
                      largest_normal_force(at_rest_, lambda);
  std::vector<double> offset(at_rest_.points().size());
  for (std::size_t k = 0; k < offset.size(); ++k) {
    const double g = gap[dim * k], force = at_rest_.local_stiffness()[k] * g;
    if (yields(at_rest_, static_cast<int>(k)) || !at_rest_.joined(static_cast<int>(k))) {
      offset[k] = g;
      continue;
    }
    const bool presses = g > 0 && force <= left && force < lambda[dim * k];
    offset[k] = std::abs(g) > round_off && !presses ? g / 2 : 0.0;
  }
  model_->set_initial_gap(std::move(offset));
}

/// The slips that points of the time step have at w = 0: mortar has given way from the slip where it stands.
PointField DynamicStep::offset_slips(const ContactState& before, const PointField& gap) const {
  const int dim = at_rest_.components();
  const auto& mortar = at_rest_.compliance();
  if (mortar.empty() || before.slip_origin.empty()) return {};
  PointField offset(gap.size(), 0.0);
  for (std::size_t k = 0; k < mortar.size(); ++k)
    for (int c = 1; c < dim && yields(at_rest_, static_cast<int>(k), c); ++c)
      offset[dim * k + c] = before.slip_origin[dim * k + c] - gap[dim * k + c];
  return offset;
}

/// Impulses of supports [N s] as a part of what they bear in the mean of the step.
void DynamicStep::bear(const std::vector<double>& impulses, TimeStepReport& report) const {
  if (impulses.empty()) return;
  add_impulses(report.reaction, at_rest_.held().held_part(impulses, at_rest_.components()), 1 / rule_.time_step);
}

/// Gives held components the velocity of their support over the step; what that takes is work of the support, and what
/// comes with it of momentum, the mass that a node stands for times dv, is borne by it. The support has that velocity
/// in all of the step, while the one that changes is half way there: so force times way is not that work.
void DynamicStep::move_supports(ContactState& state, const std::vector<double>& half, TimeStepReport& report) const {
  const int dim = at_rest_.components();
  bool mine = false;
  auto v = state.velocity;
  const auto now = at_rest_.held().held_part(v, dim);
  std::vector<double> impulses(v.size(), 0.0);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double wanted = rule_.midpoint_velocity(half[i]);  // zero where nothing is held
    mine |= now[i] != wanted;
    v[i] = (v[i] - now[i]) + wanted;
    impulses[i] = mass_of_node_[i / dim] * (wanted - now[i]);
  }
  if (!any_of_ranks(*mass_->comm(), mine)) return;
  const double work = velocities_.kinetic_energy(v) - velocities_.kinetic_energy(state.velocity);
  report.external_work += work;
  report.work_within += work - velocities_.work_of_supports(impulses, v);
  bear(impulses, report);
  state.velocity = v;
}

/// Work and losses of a step, exact, from its middle; returns the energy that the closing of points took [J].
double DynamicStep::book(const ContactState& mid, const ContactState& before, const std::vector<double>& load,
                         const std::vector<double>& effective, TimeStepReport& report) const {
  const int dim = at_rest_.components();
  const auto& s = at_rest_.structure();
  const auto& w = mid.displacement;
  report.reaction = step_->residual(mid, effective);
  const auto& reaction = report.reaction;
  std::vector<double> mw, kw;
  mass_->apply_stiffness(w, mw);
  s.apply_stiffness(w, kw);
  double work = 0, damping = 0, friction = 0, fracture = 0;
  const auto held = at_rest_.held().held_part(reaction, dim);
  for (int i = 0; i < dim * s.owned_nodes(); ++i) {
    work += 2 * w[i] * (load[i] + held[i]);
    damping += w[i] * (rule_.mass_damping * mw[i] + rule_.stiffness_damping * kw[i]) * 4 / rule_.time_step;
  }
  const auto gap = model_->gaps(w);
  const double none = at_rest_.settings().internals.step.least_noise * largest_force(at_rest_, mid);
  double lost = 0;
  for (int k = 0; k < at_rest_.points().owned(); ++k) {
    if (!mid.selected[k] || yields(at_rest_, k) || !at_rest_.bears(k)) continue;  // springs give all back
    // Only a point that fell and was stopped: what solvers leave at the others would look like an impact.
    if (const double fallen = model_->initial_gap()[k]; fallen != 0 && mid.lambda[dim * k] > none)
      lost -= 2 * mid.lambda[dim * k] * (gap[dim * k] - fallen);
    const auto loss = loss_in_time(at_rest_, before, mid, k, model_->initial_gap()[k], gap);
    friction += loss.friction;
    fracture += loss.fracture;
  }
  report.external_work = total(work);
  report.damping = total(damping);
  report.friction = total(friction);
  report.fracture = total(fracture);
  return total(lost);
}

/// Relative velocity below which points rest on each other [m/s].
double DynamicStep::resting_speed(const ContactState& state, double energy) const {
  double fastest = 0;
  for (double v : state.velocity) fastest = std::max(fastest, std::abs(v));
  const auto& numbers = at_rest_.settings().internals.time_step;
  return numbers.share_of_fastest * largest_over_ranks(*mass_->comm(), fastest) +
         numbers.share_of_energy * std::sqrt(2 * std::max(energy, 0.0) / total_mass_);
}

/// Error of the velocity in one step, dt/12 of the change of the acceleration, in the norm of energy. The change is the
/// mean of the last two: what turns from step to step is a vibration the steps are too long for, and drops out.
double DynamicStep::error(ContactState& after, const std::vector<double>& velocity_before, double energy) const {
  auto acceleration = after.velocity;
  for (std::size_t i = 0; i < acceleration.size(); ++i)
    acceleration[i] = (acceleration[i] - velocity_before[i]) / rule_.time_step;
  auto change = acceleration;
  const auto& first = after.acceleration_before;
  const bool known = any_of_ranks(*mass_->comm(), !first.empty());  // empty ranks have none
  for (std::size_t i = 0; i < first.size(); ++i) change[i] = (change[i] - first[i]) / 2;
  after.acceleration_before = std::exchange(after.acceleration, std::move(acceleration));
  after.largest_energy = std::max(after.largest_energy, energy);
  if (!known || !(after.largest_energy > 0)) return 0;
  return rule_.time_step / 12 * std::sqrt(velocities_.kinetic_energy(change) / after.largest_energy);
}

/// Ties the points that have rested, as they stand. Mortar yields wherever it presses: no tie stands for it.
/// Returns what became of the energy of their last motion.
VelocityJump DynamicStep::bond_what_rests(ContactState& state, const PointField& gap, double energy, double resting) {
  const auto& selection = at_rest_.settings().selection;
  if (selection.mode != SelectionMode::adaptive || selection.rest == 0) return {};
  const auto& joints = at_rest_.families();
  const auto mortar = [](const auto& joint) { return joint.parameters.has_mortar(); };
  if (std::any_of(joints.begin(), joints.end(), mortar)) return {};
  const double share = at_rest_.settings().internals.step.share_of_violation * selection.error_tolerance;
  const auto selected = std::max(1LL, count_selected(at_rest_, state));
  const double negligible = share * share * energy / static_cast<double>(selected);
  auto calm = velocities_.calm(state, negligible, resting);
  for (std::size_t k = 0; k < at_rest_.never_tied().size(); ++k)
    if (at_rest_.never_tied()[k]) calm[k] = 0;
  for (std::size_t k = 0; k < calm.size(); ++k)
    if (!at_rest_.joined(static_cast<int>(k))) calm[k] = 0;  // a tie would hold a stone by one that is not there
  const bool mine = voussoir::bond_what_rests(state.rest, state.selected, gap, at_rest_.local_stiffness(), calm,
                                              negligible, selection.rest, at_rest_.settings().internals.rest);
  if (!any_of_ranks(*mass_->comm(), mine)) return {};
  state.rest.error = {};
  return velocities_.settle(state, resting);
}

DynamicStep::Midpoint DynamicStep::midpoint(const ContactState& before, const StepInput& input) const {
  const int dim = at_rest_.components();
  const auto& s = at_rest_.structure();
  Midpoint mid;
  std::vector<double> mv;
  s.apply_stiffness(before.displacement, mid.load);
  mass_->apply_stiffness(before.velocity, mv);
  double elastic = 0, kinetic = 0;
  for (int i = 0; i < dim * s.owned_nodes(); ++i) {
    elastic += before.displacement[i] * mid.load[i] / 2;
    kinetic += before.velocity[i] * mv[i] / 2;
  }
  mid.energy = total(elastic) + total(kinetic);
  mid.half.resize(mid.load.size());
  for (std::size_t i = 0; i < mid.load.size(); ++i) {
    mid.load[i] = input.load[i] - mid.load[i] + 2 / rule_.time_step * mv[i];
    mid.half[i] = (input.prescribed[i] - before.displacement[i]) / 2;
  }
  mid.half = at_rest_.held().held_part(mid.half, dim);
  return mid;
}

/// What joints go through from the middle of a step to its end. How far they are open there is asked of the
/// displacements that the next step begins with, so that a joint that has not closed again is at its largest opening to
/// the last bit: short of it by round-off it would be taken for one that closes.
void DynamicStep::wear_to_the_end(const ContactState& before, const PointField& slips, ContactState& mid) const {
  const int dim = at_rest_.components();
  auto at_end = model_->gaps(mid.displacement);
  const auto middle = model_->gaps(mid.displacement, mid.lambda);
  const auto opening = at_rest_.gaps(displacement_at_end(before, mid));
  for (std::size_t i = 0; i < at_end.size(); ++i) {
    const bool is_normal = i % dim == 0;
    if (!yields(at_rest_, static_cast<int>(i / dim), static_cast<int>(i % dim)))
      at_end[i] = is_normal ? opening[i] : 2 * at_end[i];
    else
      at_end[i] = is_normal || slips.empty() ? middle[i] : 2 * (middle[i] - slips[i]);
  }
  wear(at_rest_, before, mid, at_end, at_end);
}

std::vector<double> DynamicStep::displacement_at_end(const ContactState& before, const ContactState& mid) const {
  auto end = before.displacement;
  for (std::size_t i = 0; i < end.size(); ++i) end[i] = rule_.displacement_at_end(end[i], mid.displacement[i]);
  return end;
}

/// The state at the end of a step, but for what joints that closed do to velocities. All that is no motion is as the
/// middle of the step has left it.
ContactState DynamicStep::at_end(const ContactState& before, ContactState mid, const PointField& slips) const {
  const int dim = at_rest_.components();
  auto after = std::move(mid);
  const auto slipped = model_->gaps(after.displacement, after.lambda);  // of the stones, with what mortar gives way
  for (std::size_t i = 0; i < after.displacement.size(); ++i)
    after.velocity[i] = rule_.velocity_at_end(before.velocity[i], after.displacement[i]);
  after.displacement = displacement_at_end(before, after);
  after.slip_origin = before.slip_origin;
  if (after.slip_origin.empty()) return after;
  after.slip_origin = slip_origins(at_rest_, after, at_rest_.gaps(after.displacement), before.slip_origin);
  for (std::size_t i = 0; i < slipped.size(); ++i)
    if (i % dim != 0 && yields(at_rest_, static_cast<int>(i / dim), static_cast<int>(i % dim)))
      after.slip_origin[i] = before.slip_origin[i] + 2 * (slipped[i] - slips[i]);
  return after;
}

/// What joints that closed do to velocities, what rests is tied, and the energies after it. False where that fails.
bool DynamicStep::update_velocities(ContactState& after, const std::vector<double>& velocity_before, double closing,
                                    TimeStepReport& report) {
  const int dim = at_rest_.components();
  const auto& s = at_rest_.structure();
  std::vector<double> ku;
  s.apply_stiffness(after.displacement, ku);
  double elastic = 0;
  for (int i = 0; i < dim * s.owned_nodes(); ++i) elastic += after.displacement[i] * ku[i] / 2;
  report.elastic = total(elastic + held_by_joints(at_rest_, after) + at_rest_.mortar_energy(after.lambda));
  const double energy = report.elastic + velocities_.kinetic_energy(after.velocity);
  const double resting = resting_speed(after, energy);
  try {
    const auto jump =
        velocities_.apply(*model_, after, closing, resting, {rule_.time_step, std::max(0.0, report.friction)});
    const auto tied = bond_what_rests(after, at_rest_.gaps(after.displacement), energy, resting);
    report.friction += jump.friction + tied.friction;
    auto impulses = jump.impulses;
    add_impulses(impulses, tied.impulses);
    report.external_work += velocities_.work_of_supports(impulses, after.velocity);
    bear(impulses, report);
  } catch (const SolverFailure& failure) {  // of all ranks; a shorter step asks for less
    report.step.newton.fail(failure.what());
    return false;
  }
  report.kinetic = velocities_.kinetic_energy(after.velocity);
  report.error = error(after, velocity_before, energy);
  return true;
}

TimeStepResult DynamicStep::take(const ContactState& before, const StepInput& input) {
  VOUSSOIR_EXPECT(step_ && "a time step has been set");
  expect_state(at_rest_, before);
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, before.velocity) && "velocity: of node copies, in time");
  expect_input(at_rest_, input);
  const auto gap = at_rest_.gaps(before.displacement);
  offset_gaps(gap, before.lambda);
  const auto midpoint = this->midpoint(before, input);
  const InTime in_time{midpoint.energy, input.load};
  ContactState start = before;  // of the load step: w = 0, and slips count from there
  start.displacement.assign(start.displacement.size(), 0.0);
  start.slip_origin = offset_slips(before, gap);
  auto [mid, step] = step_->take(start, {midpoint.load, midpoint.half, &in_time});
  TimeStepResult result;
  auto& [after, report] = result;
  report.step = std::move(step);
  report.step.newton.penetration *= 2;  // at the end the gap is twice that of the middle
  if (!report.step.converged()) {
    after = report.step.newton.stopped ? before : std::move(mid);
    return result;
  }
  if (at_rest_.weakens()) wear_to_the_end(before, start.slip_origin, mid);
  const double closing = std::max(0.0, book(mid, before, input.load, midpoint.load, report));
  after = at_end(before, std::move(mid), start.slip_origin);
  move_supports(after, midpoint.half, report);
  if (!update_velocities(after, before.velocity, closing, report)) return result;
  after.status = point_statuses(at_rest_, after, at_rest_.gaps(after.displacement, after.lambda), before.slip_origin);
  if (!std::isfinite(report.elastic + report.kinetic))
    report.step.newton.fail("the energy after the step is no number");
  return result;
}

}  // namespace voussoir
