// What a contact solver does where joints soften: strength that falls by what states wear, and which of several
// equilibria a structure stays in (stability.md).
#include <algorithm>
#include <cmath>
#include <utility>

#include "nonlinear/contact_solver.hpp"
#include "nonlinear/parted_joints.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"
#include "nonlinear/stability.hpp"

namespace voussoir {
namespace {

/// Damage of points that are where a state has them and bear its forces, and whether on any rank one has broken off by
/// far. Collective.
WornPoints worn(NonlinearProblem& problem, const Iterate& at, StrengthIs strength) {
  PointField gap;
  TpetraVector residual(problem.map());
  problem.evaluate(at.x, residual, gap);
  auto all = wear(problem, {&at.damage, strength}, at.lambda, gap);
  all.by_far = largest_over_ranks(problem, all.by_far) > 0;
  return all;
}

}  // namespace

/// States on the way may have worn points more than the one arrived at: an equilibrium close by does without that.
void ContactSolver::forget_the_way(const Iterate& at, double tolerance, NewtonReport& report) {
  auto of_the_way = std::exchange(at.damage, give_back(*problem_.softening(), at.damage));
  if (measure(at, StrengthIs::falling, report) <= tolerance) return;
  const int patience = methods_.active_set.patience;
  const bool there = try_active_set(at, {tolerance}, patience, report) == ActiveSetEnd::arrived;
  if (there || report.stopped) return;
  const auto of_the_state = worn(problem_, at, StrengthIs::falling).damage;
  report.lost_on_the_way = largest_over_ranks(problem_, lost_beyond(*problem_.softening(), of_the_way, of_the_state));
  at.damage = std::move(of_the_way);
}

/// Where the state gives way on its own it is followed down to one that does not. What cannot be left stays, and the
/// report says by how much it gives way.
void ContactSolver::find_stable_branch(const Iterate& at, double tolerance, NewtonReport& report) {
  const int before = report.newton_iterations;
  const int most = std::min(before + std::max(static_cast<int>(StabilityParameters::solves_of_step * before),
                                              StabilityParameters::most_motions),
                            parameters_.largest_iterations);
  while (true) {
    const auto found = find_instability(problem_, at.x, at.lambda, at.damage, report);
    report.unstable = found.any ? found.excess : 0;
    report.unstable_at = found.leader;
    if (report.newton_iterations >= most) return;
    const bool left =
        found.any ? leave_branch(found, 1, at, tolerance, report) || leave_branch(found, -1, at, tolerance, report)
                  : close_needless_cracks(at, tolerance, most - report.newton_iterations, report);
    if (!left) return;
    report.choose(found.runs_on.joints, found.runs_on.number);
    if (report.stopped) return;
  }
}

/// Cracks joints one by one from the state that is given, whose joints are to have the damage that they begin with,
/// with as many solves as are left for it. Leaves the outcome in the report.
void ContactSolver::crack_one_by_one(const Iterate& at, double tolerance, int left, NewtonReport& report) {
  const double rough = std::max(tolerance, methods_.solver.held_accuracy);
  LetCrack cracks;
  report.fail("the largest number of linear solves was reached");
  for (auto found_with = StrengthIs::falling;; found_with = StrengthIs::held) {
    const auto next = wear_one_more(problem_, at, found_with, cracks);
    if (next.number < 0) break;
    report.choose(next.joints, next.number);
    if (report.newton_iterations >= left) return;
    const ContactRequest request{rough, StrengthIs::held};
    if (measure(at, StrengthIs::held, report) <= rough) continue;
    if (try_active_set(at, request, methods_.active_set.patience, report) != ActiveSetEnd::arrived) {
      if (!report.stopped) go_the_ways(at, request, report);
      if (report.stopped || report.outcome != NewtonOutcome::converged) return;
    }
  }
  wear_down(at, {tolerance}, report);
}

/// Where joints have parted side by side: an equilibrium with less potential in which those have stayed whole that need
/// not part. False where none is found; then all is as before.
bool ContactSolver::close_needless_cracks(const Iterate& at, double tolerance, int left, NewtonReport& report) {
  if (!problem_.softening() || parted_side_by_side(problem_, at) < 2) return false;
  const SavedPosition from(problem_, at.x);
  PointField lambda_from = at.lambda;
  Damage damage_from = std::exchange(at.damage, problem_.softening()->at_start());
  NewtonReport attempt;
  crack_one_by_one(at, tolerance, left, attempt);
  if (attempt.outcome == NewtonOutcome::converged) forget_the_way(at, tolerance, attempt);
  report.add_work(attempt);
  if (report.stopped) return true;
  if (attempt.outcome == NewtonOutcome::converged) {
    TpetraVector x_from(at.x, Teuchos::Copy);
    from.restore(x_from);
    const auto beyond = potential_beyond(problem_, {x_from, lambda_from, damage_from}, at);
    if (beyond.potential < -StabilityParameters::neutral * beyond.taken) {
      report.choose(attempt.alike, attempt.alike_at);
      report.lost_on_the_way = attempt.lost_on_the_way;
      return true;
    }
  }
  from.restore(at.x);
  at.lambda = std::move(lambda_from);
  at.damage = std::move(damage_from);
  return false;
}

/// Goes down along a motion and solves from there: first with the damage that the state has, then with that of the way
/// down, which is given back in the end. False where no other state is found; then all is as before.
bool ContactSolver::leave_branch(const Instability& found, double sign, const Iterate& at, double tolerance,
                                 NewtonReport& report) {
  const SavedPosition from(problem_, at.x);
  const PointField lambda_from = at.lambda;
  const Damage damage_from = at.damage;
  TpetraVector below(at.x, Teuchos::Copy);
  const double way = go_down(problem_, found, sign, at.damage, below, at.lambda) * found.motion->normInf();
  const SavedPosition start(problem_, below);
  const PointField lambda_start = at.lambda;
  const auto is_another = [&] { return from.distance(at.x) > StabilityParameters::back_again * way; };
  for (const bool worn_first : {false, true}) {
    start.restore(at.x);
    at.lambda = lambda_start;
    NewtonReport attempt;
    if (worn_first) {
      at.damage = worn(problem_, at, StrengthIs::falling).damage;
      wear_down(at, {tolerance}, attempt);
      if (attempt.outcome == NewtonOutcome::converged) forget_the_way(at, tolerance, attempt);
    } else {
      try_active_set(at, {tolerance}, methods_.active_set.patience, attempt);
    }
    const bool arrived = attempt.outcome == NewtonOutcome::converged && is_another();
    report.add_work(attempt);
    if (report.stopped) return true;
    if (arrived) {
      report.lost_on_the_way = attempt.lost_on_the_way;
      return true;
    }
    at.damage = damage_from;
  }
  from.restore(at.x);
  at.lambda = lambda_from;
  return false;
}

void ContactSolver::wear_down(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  const auto& numbers = methods_.solver;
  const double tolerance = request.tolerance;
  report.fail("the largest number of linear solves was reached");
  ContactRequest rough{std::max(tolerance, numbers.held_accuracy), StrengthIs::held, request.known_gap};
  while (report.newton_iterations < parameters_.largest_iterations) {
    const bool there = (!rough.known_gap && measure(at, StrengthIs::held, report) <= rough.tolerance) ||
                       try_active_set(at, rough, methods_.active_set.patience, report) == ActiveSetEnd::arrived;
    if (!there) {
      if (!report.stopped) go_the_ways(at, rough, report);
      if (report.stopped || report.outcome != NewtonOutcome::converged) return;
      report.fail("the largest number of linear solves was reached");
    }
    rough.known_gap = nullptr;
    auto after = worn(problem_, at, StrengthIs::held);
    at.damage = std::move(after.damage);
    if (after.by_far) continue;  // what it bore goes elsewhere first
    rough.tolerance = std::max(tolerance, rough.tolerance / 10);
    if (measure(at, StrengthIs::falling, report) <= tolerance ||
        try_active_set(at, {tolerance}, methods_.active_set.patience, report) == ActiveSetEnd::arrived) {
      report.outcome = NewtonOutcome::converged;
      return;
    }
    if (report.stopped) return;
  }
}

/// Where joints soften a state is to be what its step makes it, not the way to it, and one that stays.
void ContactSolver::leave_the_way(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  if (!problem_.softening() || request.strength != StrengthIs::falling) return;
  forget_the_way(at, request.tolerance, report);
  if (!report.stopped && !parameters_.has_inertia) find_stable_branch(at, request.tolerance, report);
}

}  // namespace voussoir
