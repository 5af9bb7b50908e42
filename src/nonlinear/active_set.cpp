#include "nonlinear/active_set.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"

namespace voussoir {
namespace {

/// Where a patch was nearest to rest.
struct Nearest {
  double size = std::numeric_limits<double>::infinity();
  std::unique_ptr<SavedPosition> position;
  PointField lambda;
};

}  // namespace

ActiveSet::ActiveSet(NonlinearProblem& problem, ActiveSetUse use, const MethodParameters& methods, int patience)
    : problem_(problem),
      numbers_(methods.active_set),
      patches_(methods.patches),
      use_(use),
      augmentation_(in_time() ? numbers_.augmentation_in_time : numbers_.augmentation_at_rest),
      proximal_(in_time() ? 0 : 1),
      most_patience_(patience),
      patience_(patience),
      sliding_(problem.points()),
      stops_(problem.points()) {
  VOUSSOIR_EXPECT(problem.components() == 2);
  for (auto* v : {&linear_, &gradient_, &direction_}) *v = Teuchos::rcp(new TpetraVector(problem.map()));
}

/// Statuses that forces and gaps ask for. Where they are those of the last solve, which has left no stone out of
/// balance, forces creep.
/// @param in_balance  no stone is out of balance by more than the tolerance
void ActiveSet::choose(const PointField& lambda, const PointField& gap, bool in_balance) {
  const auto resistance = std::move(resistance_);
  const auto sliding = std::move(sliding_);
  set_statuses(lambda, gap, sliding);
  const bool may_creep =
      numbers_.creeping && !in_time() && (in_balance || augmentation_ != numbers_.augmentation_at_rest);
  settled_ = (in_time() || may_creep) && same_statuses(resistance, sliding);
  if (!may_creep) return;
  const double wanted = !settled_    ? numbers_.augmentation_at_rest
                        : in_balance ? numbers_.augmentation_of_creeping
                                     : augmentation_;
  if (wanted == augmentation_) return;
  augmentation_ = wanted;
  set_statuses(lambda, gap, sliding);
}

/// Whether all points of all ranks have the statuses that they had. Collective.
bool ActiveSet::same_statuses(const std::vector<PointStiffness>& resistance, const std::vector<double>& sliding) const {
  bool differ = resistance.size() != resistance_.size() || sliding != sliding_;
  for (std::size_t k = 0; !differ && k < resistance.size(); ++k)
    differ = (resistance[k].normal > 0) != (resistance_[k].normal > 0) ||
             (resistance[k].tangential > 0) != (resistance_[k].tangential > 0);
  return largest_over_ranks(*problem_.map()->getComm(), differ) == 0;
}

/// No point turns from one direction of slip, before, to the other: between them it sticks.
void ActiveSet::set_statuses(const PointField& lambda, const PointField& gap, const std::vector<double>& before) {
  resistance_.assign(problem_.points(), {});
  sliding_.assign(problem_.points(), 0.0);
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& law = problem_.law()[k];
    const auto trial = [&](int c) {
      return lambda[2 * k + c] - stiffness_of(problem_, k, c, 1.0) * motion_of(problem_, k, c, gap, lambda);
    };
    const double p = trial(0), q = trial(1);
    if (!(p > -law.tension)) continue;
    auto& r = resistance_[k];
    r.normal = stiffness_of(problem_, k, 0, augmentation_);
    const double bound = friction_bound(law, p);
    const double direction = q < 0 ? -1 : 1;
    if (std::abs(q) < bound || (bound > 0 && (direction == -before[k] || stops_[k] != 0))) {
      r.tangential = stiffness_of(problem_, k, 1, augmentation_);
    } else {
      sliding_[k] = direction;
      if (bound > 0) r.coupling = sliding_[k] * law.friction * r.normal;
    }
  }
}

/// Forces of all points at these gaps.
void ActiveSet::aim(const PointField& lambda) {
  target_ = lambda;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& law = problem_.law()[k];
    const auto& r = resistance_[k];
    double& p = target_[2 * k];
    double& q = target_[2 * k + 1];
    if (r.normal > 0)
      p -= r.normal * motion_of(problem_, k, 0, gap_, lambda);
    else
      p = -law.tension;
    if (r.tangential > 0)
      q -= r.tangential * motion_of(problem_, k, 1, gap_, lambda);
    else if (r.normal > 0)
      q = sliding_[k] * (r.coupling != 0 ? law.cohesion + law.friction * p : friction_bound(law, p));
    else
      q = std::clamp(q, -friction_bound(law, p), friction_bound(law, p));
  }
}

/// Residuals of x with the forces that the law admits; leaves K x - f in linear_, the gaps and those forces.
double ActiveSet::measure(const TpetraVector& x, const PointField& lambda, NewtonReport& report) {
  problem_.evaluate(x, *linear_, gap_);
  std::vector<double> bound;
  friction_bounds(problem_, lambda, bound);
  admissible_ = lambda;  // what tied points bear stays
  project(problem_, lambda, bound, admissible_);
  Tpetra::deep_copy(*gradient_, *linear_);
  const auto [equilibrium, contact] = imbalance(problem_, admissible_, gap_, *gradient_);
  scale_ = force_scale(problem_, admissible_);
  report.residual = equilibrium / scale_;
  report.complementarity = contact / scale_;
  return std::max(report.residual, report.complementarity);
}

/// Share of the step from lambda to force_ after which residuals have fallen, or are least.
double ActiveSet::step_length(const PointField& lambda) const {
  // Out of balance: linear along the step.
  TpetraVector start(*linear_, Teuchos::Copy), end(*linear_, Teuchos::Copy);
  end.update(1.0, *gradient_, 1.0);
  problem_.subtract_contact_forces(lambda, start);
  problem_.subtract_contact_forces(force_, end);
  const double start2 = start.dot(start), mixed = start.dot(end), end2 = end.dot(end);
  PointField force(lambda.size()), gap(gap_.size()), lawful;
  const auto merit = [&](double t) {  // [N2]
    for (std::size_t i = 0; i < force.size(); ++i) {
      force[i] = lambda[i] + t * (force_[i] - lambda[i]);
      gap[i] = gap_[i] + t * gap_direction_[i];
    }
    lawful_forces(problem_, force, gap, lawful);
    double mine = 0;
    for (int k = 0; k < problem_.owned_points(); ++k)
      for (int i = 2 * k; problem_.selected()[k] && i < 2 * k + 2; ++i)
        mine += (lawful[i] - force[i]) * (lawful[i] - force[i]);
    const double unlawful2 = total_over_ranks(*problem_.map()->getComm(), mine);
    return (1 - t) * ((1 - t) * start2 + 2 * t * mixed) + t * t * end2 + unlawful2;
  };
  const double before = merit(0);
  double least = std::numeric_limits<double>::infinity(), best = 1;
  for (double t = 1; t >= numbers_.shortest; t /= 2) {
    const double m = merit(t);
    if (m < least) {
      least = m;
      best = t;
    }
    if (m < (1 - numbers_.descent * t) * before) break;
  }
  return best;
}

/// Of the next linear solve, relative to its right side. Where statuses stay it may be the last one: then it leaves no
/// more than the resistances of closed points do. At rest such solves are rare.
double ActiveSet::accuracy_of_next(double tolerance, const NewtonReport& report) const {
  if (!settled_ || !in_time()) return numbers_.accuracy;
  const double left = std::max(tolerance, report.complementarity / augmentation_) * scale_;
  return std::clamp(left / (2 * gradient_->norm2()), numbers_.finest_accuracy, numbers_.accuracy);
}

/// One linear solve with the statuses chosen. What damping resists is no force: nothing of it is left once points rest.
/// Where a library refused the system nothing moves.
/// @param damping  of points that give way, relative to their local stiffness
/// @param most     Krylov iterations
LinearSolveResult ActiveSet::step(TpetraVector& x, PointField& lambda, double damping, double relative_tolerance,
                                  int most) {
  auto damped = resistance_;
  for (int k = 0; damping > 0 && k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    damped[k].normal = std::max(damped[k].normal, stiffness_of(problem_, k, 0, damping));
    damped[k].tangential = std::max(damped[k].tangential, stiffness_of(problem_, k, 1, damping));
  }
  direction_->putScalar(0);
  const auto solved = problem_.solve(damped, proximal_, gradient_, direction_, {relative_tolerance, most, !in_time()});
  if (solved.nothing) return solved;
  problem_.evaluate_direction(*direction_, *gradient_, gap_direction_);
  force_ = target_;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& r = resistance_[k];
    force_[2 * k] -= r.normal * gap_direction_[2 * k];
    force_[2 * k + 1] -= r.tangential * gap_direction_[2 * k + 1] + r.coupling * gap_direction_[2 * k];
  }
  length_ = in_time() && numbers_.step_lengths ? step_length(lambda) : 1.0;
  x.update(length_, *direction_, 1.0);
  if (length_ == 1)
    lambda = force_;
  else
    for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] += length_ * (force_[i] - lambda[i]);
  return solved;
}

/// Brings the stones that keep residuals up to rest. Returns whether that may be tried again.
/// @param known  residual that has been reached before
/// @param size   of the state, written over
bool ActiveSet::correct_locally(TpetraVector& x, PointField& lambda, double tolerance, const TpetraVector& start,
                                double known, double& size, NewtonReport& report) {
  const TpetraVector x_before(x, Teuchos::Copy);
  const PointField lambda_before = lambda;
  const double size_before = size;
  lambda = admissible_;
  const int solves =
      problem_.correct_locally(x, lambda,
                               {std::max(tolerance, patches_.block_threshold * known) * scale_,
                                std::max(patches_.aim_of_tolerance * tolerance, patches_.aim_of_residual * known),
                                scale_, known * scale_, patches_.bearable_rise * known * scale_, resistance_, start});
  if (solves == 0) {
    lambda = lambda_before;
    return true;
  }
  report.local_solves += solves;
  size = measure(x, lambda, report);
  tell(report, 0, solves);
  if (size <= patches_.bearable_rise * size_before) return true;
  Tpetra::deep_copy(x, x_before);
  lambda = lambda_before;
  size = measure(x, lambda, report);
  return false;
}

/// Moves stones that nothing holds to where a point holds them, which sticks in the next solve.
void ActiveSet::move_loose_stones(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  TpetraVector imbalance(*linear_, Teuchos::Copy);
  problem_.subtract_contact_forces(admissible_, imbalance);
  const auto stops = problem_.move_loose_stones(
      x, {resistance_, sliding_, admissible_, gap_, imbalance, tolerance * scale_});
  stops_.assign(problem_.points(), 0);
  for (int k : stops) stops_[k] = 1;
  if (!stops.empty()) measure(x, lambda, report);
}

ActiveSetEnd ActiveSet::solve(TpetraVector& x, PointField& lambda, double tolerance, int largest_solves,
                              const PointField* known_gap, NewtonReport& report) {
  const double largest_force = force_scale(problem_, lambda), start = measure(x, lambda, report);
  double best = std::numeric_limits<double>::infinity(), damping = 0;
  const bool damps = numbers_.damping;
  const double least_damping = damps && use_ == ActiveSetUse::in_patch ? numbers_.damping_in_patch : 0;
  bool local = true;
  Nearest nearest;
  for (int solves = 0, last_gain = 0; solves < largest_solves && solves < last_gain + patience_;) {
    if (problem_.carry(x, tolerance * scale_)) measure(x, lambda, report);
    choose(lambda, known_gap && solves == 0 ? *known_gap : gap_, report.residual <= tolerance);
    aim(lambda);
    const TpetraVector x_before(x, Teuchos::Copy), linear_before(*linear_, Teuchos::Copy);
    double size = 0, undamped = std::numeric_limits<double>::infinity();
    for (;;) {
      Tpetra::deep_copy(*gradient_, linear_before);
      problem_.subtract_contact_forces(target_, *gradient_);
      gradient_->scale(-1.0);
      const double share = in_time() ? 1.0 : std::min(1.0, numbers_.flown * largest_force / gradient_->normInf());
      const int most = in_time() ? 0 : std::isinf(best) ? numbers_.many_krylov : numbers_.most_krylov;
      const double asked =
          std::max(std::numeric_limits<double>::epsilon(), share * accuracy_of_next(tolerance, report));
      const auto solved = step(x, lambda, std::max(damping, least_damping), asked, most);
      const int krylov = solved.iterations;
      report.count(solved);
      ++solves;
      if (solved.nothing) {
        size = std::numeric_limits<double>::infinity();
        break;
      }
      size = measure(x, lambda, report);
      tell(report, krylov);
      const double expected = std::isinf(best) ? tolerance : std::max(tolerance, patches_.trigger * best);
      if (patches_.used && use_ == ActiveSetUse::at_rest && local && size > expected) {
        local = correct_locally(x, lambda, tolerance, x_before, std::min({size, best, 1.0}), size, report);
        patience_ = local ? most_patience_ : std::min(most_patience_, numbers_.patience_alone);
      }
      if (size <= tolerance) {
        lambda = admissible_;
        report.outcome = NewtonOutcome::converged;
        return ActiveSetEnd::arrived;
      }
      if (in_time()) break;  // nothing flies
      const bool still_far = best > numbers_.near && size > numbers_.gained * best;
      if (krylov >= numbers_.many_krylov && (std::isinf(best) || still_far)) return ActiveSetEnd::loose_stones;
      // Supports that have moved are no measure: what they leave at the start says little of what follows.
      const double known = known_gap ? best : std::min(best, start);
      if (!damps || size <= numbers_.lost * known) break;
      if (damping >= numbers_.largest_damping || solves >= largest_solves) break;
      if (size > numbers_.damped * std::exchange(undamped, size)) break;
      damping = std::max(numbers_.damping_factor * damping, numbers_.first_damping);
      Tpetra::deep_copy(x, x_before);
    }
    if (!std::isfinite(size)) break;
    if (use_ == ActiveSetUse::in_patch && size < nearest.size)
      nearest = {size, std::make_unique<SavedPosition>(problem_, x), admissible_};
    damping = damping > numbers_.no_damping ? damping / numbers_.damping_factor : 0;
    if (patches_.loose_stones && use_ == ActiveSetUse::in_patch) move_loose_stones(x, lambda, tolerance, report);
    if (size > numbers_.gained * best) continue;
    best = size;
    last_gain = solves;
    local = true;
  }
  if (nearest.position) {
    nearest.position->restore(x);
    lambda = nearest.lambda;
    measure(x, lambda, report);
  }
  return ActiveSetEnd::circled;
}

void ActiveSet::tell(const NewtonReport& report, int krylov, int local_solves) const {
  long long mine[2] = {0, 0}, all[2];
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    mine[0] += resistance_[k].normal > 0;
    mine[1] += sliding_[k] != 0;
  }
  Teuchos::reduceAll(*problem_.map()->getComm(), Teuchos::REDUCE_SUM, 2, mine, all);  // all ranks, listening or not
  if (!narrate) return;
  narrate({report.newton_iterations, report.residual * scale_, report.complementarity * scale_, all[0], all[1], krylov,
           length_, augmentation_, local_solves});
}

}  // namespace voussoir
