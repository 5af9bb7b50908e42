#include "nonlinear/contact_solver.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"
#include "nonlinear/stability.hpp"

namespace voussoir {
namespace {

/// Points wear by where they are and what they bear. Whether a brittle one has broken off, far beyond what it bears.
bool take_wear(NonlinearProblem& problem, const TpetraVector& x, const PointField& lambda) {
  PointField gap;
  TpetraVector residual(problem.map());
  problem.evaluate(x, residual, gap);
  return largest_over_ranks(problem, wear_by(problem, lambda, gap)) > 0;
}

}  // namespace

ContactSolver::ContactSolver(NonlinearProblem& problem, const NewtonParameters& parameters,
                             const MethodParameters& methods, FastWay& fast)
    : problem_(problem),
      parameters_(parameters),
      methods_(methods),
      fast_(fast),
      mechanism_(Teuchos::rcp(new TpetraVector(problem.map()))) {}

/// Residuals of a state, relative to the largest force, and its penetration. Returns the larger residual. Collective.
double ContactSolver::measure(const TpetraVector& x, const PointField& lambda, NewtonReport& report) const {
  TpetraVector residual(problem_.map());
  PointField gap;
  const double size = judge_state(problem_, x, lambda, residual, gap, report);
  double penetration = 0;
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const int normal = k * problem_.components();
    penetration = std::max(penetration, -gap[normal] - compliance_of(problem_, k, 0) * lambda[normal]);
  }
  report.penetration = largest_over_ranks(problem_, penetration);
  return size;
}

/// Without contact points one linear solve is the answer. Where solves do not gain, supports may leave the structure
/// free to move: it is let go.
void ContactSolver::solve_linear(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  const auto b = Teuchos::rcp(new TpetraVector(problem_.map())), d = Teuchos::rcp(new TpetraVector(problem_.map()));
  PointField gap;
  double size = measure(x, lambda, report);
  for (double last = std::numeric_limits<double>::infinity(); size > tolerance;
       last = std::exchange(size, measure(x, lambda, report))) {
    const int left = parameters_.largest_iterations - report.newton_iterations;
    if (left <= 0) return report.fail("the largest number of linear solves was reached");
    if (size > methods_.pseudo_time.unchanged * last && methods_.pseudo_time.used) {
      x.update(-1.0, *d, 1.0);  // of a system that may have no solution
      return in_pseudo_time(x, lambda, tolerance, nullptr, left, report);
    }
    problem_.carry(x, tolerance * force_scale(problem_, lambda));
    problem_.evaluate(x, *b, gap);
    problem_.subtract_contact_forces(lambda, *b);
    b->scale(-1.0);
    d->putScalar(0);
    // The norm of what a solve leaves bounds the largest residual.
    const double aim = tolerance * force_scale(problem_, lambda) / b->norm2();
    const auto solved =
        problem_.solve(std::vector<PointStiffness>(problem_.points()), 0.0, b, d,
                       {std::clamp(aim, methods_.solver.finest_accuracy, methods_.path.solve_accuracy)});
    report.count(solved);
    x.update(1.0, *d, 1.0);
    report.tell(watch, {report.newton_iterations, report.residual, 0, 0, 0, solved.iterations});
    if (report.stopped) return;
  }
  report.outcome = NewtonOutcome::converged;
}

bool ContactSolver::may_be_fast() {
  if (!methods_.solver.active_sets || parameters_.time_follows) return false;
  if (!methods_.solver.back_off) return true;
  if (!parameters_.has_inertia && fast_.wait > 0) {
    --fast_.wait;
    return false;
  }
  fast_.wait = fast_.next_wait;  // unless they arrive
  fast_.next_wait = std::min(2 * fast_.next_wait + 1, methods_.solver.longest_wait);
  return true;
}

ActiveSetEnd ContactSolver::try_active_set(TpetraVector& x, PointField& lambda, double tolerance,
                                           const PointField* known_gap, int patience, NewtonReport& report) {
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  ActiveSet active(problem_, parameters_.has_inertia ? ActiveSetUse::in_time : ActiveSetUse::at_rest, methods_,
                   patience);
  active.watch = watch;
  const int most = std::min(methods_.solver.fast_solves, parameters_.largest_iterations);
  const auto end = active.solve(x, lambda, tolerance, most, known_gap, report);
  if (end != ActiveSetEnd::arrived) {
    before.restore(x);
    lambda = lambda_before;
  }
  return end;
}

PathEnd ContactSolver::along_the_path(TpetraVector& x, PointField& lambda, double tolerance,
                                      const PointField* known_gap, bool shortcut, NewtonReport& report) {
  InteriorPath interior(problem_, methods_);
  interior.watch = watch;
  if (shortcut)
    interior.shortcut = [&](TpetraVector& near_x, PointField& near_lambda) {
      return try_active_set(near_x, near_lambda, tolerance, nullptr, methods_.solver.patience_from_near, report) ==
             ActiveSetEnd::arrived;
    };
  const int steps = std::min(methods_.solver.largest_path, parameters_.largest_iterations - report.newton_iterations);
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  NewtonReport only_residuals;
  const double off_before = measure(x, lambda, only_residuals) * force_scale(problem_, lambda);
  const auto end = interior.follow(x, lambda, tolerance, steps, known_gap, report);
  if (end != PathEnd::stuck) return end;
  if (measure(x, lambda, only_residuals) * force_scale(problem_, lambda) <= off_before) return end;
  before.restore(x);
  lambda = lambda_before;
  return PathEnd::ran_away;
}

void ContactSolver::in_pseudo_time(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                                   int most, NewtonReport& report) {
  PseudoTime falling(problem_, parameters_, methods_);
  falling.watch = watch;
  falling.follow(x, lambda, tolerance, known_gap, most, report);
  Tpetra::deep_copy(*mechanism_, falling.mechanism());
}

void ContactSolver::go_the_ways(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                                NewtonReport& report) {
  const bool has_path = methods_.path.used;
  bool shortcut = methods_.solver.shortcut && fast_.offered && !parameters_.time_follows;
  for (int most = methods_.solver.closing_solves;; most *= 2) {
    if (has_path) {
      const auto end = along_the_path(x, lambda, tolerance, known_gap, std::exchange(shortcut, false), report);
      if (end == PathEnd::arrived) {
        report.outcome = NewtonOutcome::converged;
        return;
      }
      if (report.stopped) return;
      if (end == PathEnd::stuck) known_gap = nullptr;
    }
    if (!methods_.pseudo_time.used)
      return report.fail("pseudo-time is switched off, and nothing else has closed the contact conditions");
    const int left = std::max(1, parameters_.largest_iterations - report.newton_iterations);
    const bool last = !has_path || left <= most;
    in_pseudo_time(x, lambda, tolerance, known_gap, last ? left : most, report);
    if (report.stopped || report.outcome != NewtonOutcome::not_converged || report.no_way_on || last) return;
    known_gap = nullptr;
  }
}

/// States on the way may have worn points more than the one arrived at: an equilibrium close by does without that.
void ContactSolver::forget_the_way(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  auto& softening = *problem_.softening();
  auto worn = softening.since_start();
  softening.start_again();
  if (measure(x, lambda, report) <= tolerance) return;
  const int patience = methods_.active_set.patience;
  const bool there = try_active_set(x, lambda, tolerance, nullptr, patience, report) == ActiveSetEnd::arrived;
  if (there || report.stopped) return;
  take_wear(problem_, x, lambda);
  report.lost_on_the_way = largest_over_ranks(problem_, softening.lost_beyond(worn));
  softening.come_back(std::move(worn));
}

/// Where the state gives way on its own it is followed down to one that does not. What cannot be left stays, and the
/// report says by how much it gives way.
void ContactSolver::find_stable_branch(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  const int before = report.newton_iterations;
  const int most = before + std::max(static_cast<int>(StabilityParameters::solves_of_step * before),
                                     StabilityParameters::most_motions);
  while (true) {
    const auto found = find_instability(problem_, x, lambda, report);
    report.unstable = found.any ? found.excess : 0;
    report.unstable_at = found.leader;
    if (!found.any || report.newton_iterations >= std::min(most, parameters_.largest_iterations)) return;
    if (!leave(found, 1, x, lambda, tolerance, report) && !leave(found, -1, x, lambda, tolerance, report)) return;
    if (report.stopped) return;
  }
}

/// Goes down along a motion and solves from there: first with the wear of the start of the step, then with that of the
/// way down, which is given back in the end. False where no other state is found; then all is as before.
bool ContactSolver::leave(const Instability& found, double sign, TpetraVector& x, PointField& lambda, double tolerance,
                          NewtonReport& report) {
  auto& softening = *problem_.softening();
  const SavedPosition from(problem_, x);
  const PointField lambda_from = lambda;
  const auto wear_from = softening.since_start();
  TpetraVector below(x, Teuchos::Copy);
  const double way = go_down(problem_, found, sign, below, lambda) * found.motion->normInf();
  const SavedPosition start(problem_, below);
  const PointField lambda_start = lambda;
  const auto is_another = [&] { return from.distance(x) > StabilityParameters::back_again * way; };
  for (const bool worn : {false, true}) {
    start.restore(x);
    lambda = lambda_start;
    NewtonReport attempt;
    if (worn) {
      take_wear(problem_, x, lambda);
      wear_down(x, lambda, tolerance, nullptr, attempt);
      if (attempt.outcome == NewtonOutcome::converged) forget_the_way(x, lambda, tolerance, attempt);
    } else {
      try_active_set(x, lambda, tolerance, nullptr, methods_.active_set.patience, attempt);
    }
    const bool arrived = attempt.outcome == NewtonOutcome::converged && is_another();
    report.add_work(attempt);
    if (report.stopped) return true;
    if (arrived) {
      report.lost_on_the_way = attempt.lost_on_the_way;
      return true;
    }
    softening.come_back(wear_from);
  }
  from.restore(x);
  lambda = lambda_from;
  return false;
}

/// Forces that nothing tells apart do not depend on the way to this equilibrium.
void ContactSolver::split_forces(const TpetraVector& x, PointField& lambda, double tolerance) const {
  if (!problem_.shares_forces()) return;
  PointField gap;
  TpetraVector residual(problem_.map());
  problem_.evaluate(x, residual, gap);
  voussoir::split_forces(problem_, CurrentLaws(problem_, lambda, gap), gap, tolerance * force_scale(problem_, lambda),
                         lambda);
}

void ContactSolver::wear_down(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap,
                              NewtonReport& report) {
  auto& softening = *problem_.softening();
  const auto& numbers = methods_.solver;
  report.fail("the largest number of linear solves was reached");
  double rough = std::max(tolerance, numbers.held_accuracy);
  while (report.newton_iterations < parameters_.largest_iterations) {
    softening.hold(true);
    const int patience = methods_.active_set.patience;
    const bool there = (!known_gap && measure(x, lambda, report) <= rough) ||
                       try_active_set(x, lambda, rough, known_gap, patience, report) == ActiveSetEnd::arrived;
    if (!there) {
      if (!report.stopped) go_the_ways(x, lambda, rough, known_gap, report);
      if (report.stopped || report.outcome != NewtonOutcome::converged) break;
      report.fail("the largest number of linear solves was reached");
    }
    known_gap = nullptr;
    const bool broke = take_wear(problem_, x, lambda);
    softening.hold(false);
    if (broke) continue;  // what it bore goes elsewhere first
    rough = std::max(tolerance, rough / 10);
    const int near = numbers.patience_from_near;
    if (measure(x, lambda, report) <= tolerance ||
        try_active_set(x, lambda, tolerance, nullptr, near, report) == ActiveSetEnd::arrived) {
      report.outcome = NewtonOutcome::converged;
      break;
    }
    if (report.stopped) break;
  }
  softening.hold(false);
}

/// What is left to do where contact conditions are closed.
void ContactSolver::finish(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport& report) {
  if (problem_.softening() && !holds_strength_) {
    forget_the_way(x, lambda, tolerance, report);
    if (!report.stopped && !parameters_.has_inertia) find_stable_branch(x, lambda, tolerance, report);
  }
  split_forces(x, lambda, tolerance);
  const bool at_round_off = measure(x, lambda, report) == 0;
  const double left = std::max(report.residual, report.complementarity);
  report.round_off = at_round_off && left > tolerance ? left : 0;
}

NewtonReport ContactSolver::solve(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap) {
  NewtonReport report;
  if (holds_strength_) problem_.softening()->hold(true);
  if (!anything_selected(problem_)) {
    solve_linear(x, lambda, tolerance, report);
  } else if (measure(x, lambda, report) <= tolerance) {
    report.outcome = NewtonOutcome::converged;  // nothing has moved
  } else {
    auto end = ActiveSetEnd::circled;
    const bool fast = may_be_fast();
    if (fast) end = try_active_set(x, lambda, tolerance, known_gap, methods_.active_set.patience, report);
    if (end == ActiveSetEnd::arrived) {
      fast_ = {};
    } else if (!report.stopped) {
      if (fast) fast_.offered = end == ActiveSetEnd::circled;
      if (problem_.softening() && !holds_strength_)
        wear_down(x, lambda, tolerance, known_gap, report);
      else
        go_the_ways(x, lambda, tolerance, known_gap, report);
    }
  }
  if (report.outcome == NewtonOutcome::converged && !report.stopped) {
    finish(x, lambda, tolerance, report);
  } else if (report.failed_solves > 0) {
    report.reason += "; " + std::to_string(report.failed_solves) + " of " + std::to_string(report.newton_iterations) +
                     " linear solves failed, at last as " + report.failure;
  }
  if (holds_strength_) problem_.softening()->hold(false);
  if (report.stopped) report.outcome = NewtonOutcome::stopped;
  return report;
}

}  // namespace voussoir
