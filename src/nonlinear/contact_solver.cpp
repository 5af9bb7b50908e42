#include "nonlinear/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/words.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/saved_position.hpp"

namespace voussoir {

ContactSolver::ContactSolver(NonlinearProblem& problem, const NewtonParameters& parameters,
                             const MethodParameters& methods, FastWay& fast)
    : problem_(problem),
      parameters_(parameters),
      methods_(methods),
      fast_(fast),
      mechanism_(Teuchos::rcp(new TpetraVector(problem.map()))) {}

/// Residuals of a state, relative to the largest force, and its penetration. Returns the larger residual. Collective.
double ContactSolver::measure(const Iterate& at, StrengthIs strength, NewtonReport& report) const {
  TpetraVector residual(problem_.map());
  PointField gap;
  const double size = judge_state(problem_, {&at.damage, strength}, at.x, at.lambda, residual, gap, report);
  double penetration = 0;
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const int normal = k * problem_.components();
    penetration = std::max(penetration, -gap[normal] - compliance_of(problem_, k, 0) * at.lambda[normal]);
  }
  report.penetration = largest_over_ranks(problem_, penetration);
  return size;
}

/// Without contact points one linear solve is the answer. Where solves do not gain, supports may leave the structure
/// free to move: it is let go.
void ContactSolver::solve_linear(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  const auto b = Teuchos::rcp(new TpetraVector(problem_.map())), d = Teuchos::rcp(new TpetraVector(problem_.map()));
  PointField gap;
  const double tolerance = request.tolerance;
  double size = measure(at, request.strength, report);
  for (double last = std::numeric_limits<double>::infinity(); size > tolerance;
       last = std::exchange(size, measure(at, request.strength, report))) {
    const int left = parameters_.largest_iterations - report.newton_iterations;
    if (left <= 0) return report.fail("the largest number of linear solves was reached");
    if (size > methods_.pseudo_time.unchanged * last && methods_.pseudo_time.used) {
      at.x.update(-1.0, *d, 1.0);  // of a system that may have no solution
      return in_pseudo_time(at, {tolerance, request.strength}, left, report);
    }
    problem_.carry(at.x, tolerance * force_scale(problem_, at.lambda));
    problem_.evaluate(at.x, *b, gap);
    problem_.subtract_contact_forces(at.lambda, *b);
    b->scale(-1.0);
    d->putScalar(0);
    // The norm of what a solve leaves bounds the largest residual.
    const double accuracy = tolerance * force_scale(problem_, at.lambda) / b->norm2();
    const auto solved =
        problem_.solve(std::vector<PointStiffness>(problem_.points()), 0.0, b, d,
                       {std::clamp(accuracy, methods_.solver.finest_accuracy, methods_.path.solve_accuracy)});
    report.count(solved);
    at.x.update(1.0, *d, 1.0);
    report.show(watch, {report.newton_iterations, report.residual, 0, 0, 0, solved.iterations});
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
  fast_.next_wait = std::min(2 * fast_.next_wait + 1, FastWay::longest);
  return true;
}

ActiveSetEnd ContactSolver::try_active_set(const Iterate& at, const ContactRequest& request, int patience,
                                           NewtonReport& report) {
  const SavedPosition before(problem_, at.x);
  const PointField lambda_before = at.lambda;
  ActiveSet active(problem_, parameters_.has_inertia ? ActiveSetUse::in_time : ActiveSetUse::at_rest, methods_,
                   patience, {&at.damage, request.strength});
  active.watch = watch;
  const int most = std::min(methods_.solver.fast_solves, parameters_.largest_iterations);
  const auto end = active.solve(at.x, at.lambda, request.tolerance, most, request.known_gap, report);
  if (end != ActiveSetEnd::arrived) {
    before.restore(at.x);
    at.lambda = lambda_before;
  }
  return end;
}

PathEnd ContactSolver::along_the_path(const Iterate& at, const ContactRequest& request, bool shortcut,
                                      NewtonReport& report) {
  InteriorPath interior(problem_, methods_, {&at.damage, request.strength});
  interior.watch = watch;
  if (shortcut)
    interior.shortcut = [&](TpetraVector& near_x, PointField& near_lambda) {
      return try_active_set({near_x, near_lambda, at.damage}, {request.tolerance, request.strength},
                            methods_.active_set.patience, report) == ActiveSetEnd::arrived;
    };
  const int steps = std::min(methods_.solver.largest_path, parameters_.largest_iterations - report.newton_iterations);
  const SavedPosition before(problem_, at.x);
  const PointField lambda_before = at.lambda;
  NewtonReport only_residuals;
  const auto off = [&] { return measure(at, request.strength, only_residuals) * force_scale(problem_, at.lambda); };
  const double off_before = off();
  const auto end = interior.trace(at.x, at.lambda, request.tolerance, steps, request.known_gap, report);
  if (end != PathEnd::stuck || off() <= off_before) return end;
  before.restore(at.x);
  at.lambda = lambda_before;
  return PathEnd::ran_away;
}

void ContactSolver::in_pseudo_time(const Iterate& at, const ContactRequest& request, int most, NewtonReport& report) {
  PseudoTime falling(problem_, parameters_, methods_, {&at.damage, request.strength});
  falling.watch = watch;
  falling.integrate(at.x, at.lambda, request.tolerance, request.known_gap, most, report);
  Tpetra::deep_copy(*mechanism_, falling.mechanism());
}

void ContactSolver::go_the_ways(const Iterate& at, ContactRequest request, NewtonReport& report) {
  const bool has_path = methods_.path.used;
  bool shortcut = methods_.solver.shortcut && fast_.offered && !parameters_.time_follows;
  for (int most = methods_.solver.closing_solves;; most *= 2) {
    if (has_path) {
      const auto end = along_the_path(at, request, std::exchange(shortcut, false), report);
      if (end == PathEnd::arrived) {
        report.outcome = NewtonOutcome::converged;
        return;
      }
      if (report.stopped) return;
      if (end == PathEnd::stuck) request.known_gap = nullptr;
    }
    if (!methods_.pseudo_time.used)
      return report.fail("pseudo-time is switched off, and nothing else has closed the contact conditions");
    const int left = std::max(1, parameters_.largest_iterations - report.newton_iterations);
    const bool last = !has_path || left <= most;
    report.hard = true;
    in_pseudo_time(at, request, last ? left : most, report);
    if (report.stopped || report.outcome != NewtonOutcome::not_converged || report.no_way_on || last) return;
    request.known_gap = nullptr;
  }
}

/// Forces that nothing tells apart do not depend on the way to this equilibrium. Where friction has to follow, the
/// state that it leads to is solved for and split again, as long as that brings the two nearer now and then; where no
/// state is found they stay as they were, and the report says by how much they could be others.
void ContactSolver::split_forces(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  if (!problem_.shares_forces()) return;
  PointField gap;
  TpetraVector residual(problem_.map());
  double nearest = std::numeric_limits<double>::infinity();
  for (int left = methods_.active_set.patience;;) {
    problem_.evaluate(at.x, residual, gap);
    const PointField as_found = at.lambda;
    voussoir::split_forces(problem_, CurrentLaws(problem_, {&at.damage, request.strength}, at.lambda, gap), gap,
                           request.tolerance * force_scale(problem_, at.lambda), at.lambda);
    const double apart = measure(at, request.strength, report);
    if (apart <= request.tolerance) return;
    const bool nearer = apart <= methods_.active_set.gained * nearest;
    left = nearer ? methods_.active_set.patience : left - 1;
    nearest = std::min(nearest, apart);
    const PointField split = at.lambda;
    if (left == 0 || !solve_from(at, {request.tolerance, request.strength}, report)) {
      if (!report.stopped) tell_undetermined(as_found, split, report);
      at.lambda = as_found;
      return;
    }
  }
}

/// Goes on from a state that is no equilibrium; false where none is found, and then all is as it was.
bool ContactSolver::solve_from(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  if (try_active_set(at, request, methods_.active_set.patience, report) == ActiveSetEnd::arrived) return true;
  if (report.stopped) return false;
  const SavedPosition x(problem_, at.x);
  const PointField lambda = at.lambda;
  const Damage damage = at.damage;
  const bool hard = report.hard;
  report.outcome = NewtonOutcome::not_converged;
  go_the_hard_way(at, request, report);  // as many solves as the step has left
  const bool arrived = report.outcome == NewtonOutcome::converged;
  if (arrived && !report.stopped) leave_the_way(at, request, report);
  if (arrived || report.stopped) return arrived;
  report.outcome = NewtonOutcome::converged;  // as the state is that it began from
  report.reason.clear();
  report.no_way_on = false;
  report.hard = hard;
  x.restore(at.x);
  at.lambda = lambda;
  at.damage = damage;
  return false;
}

void ContactSolver::go_the_hard_way(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  if (problem_.softening() && request.strength == StrengthIs::falling)
    wear_down(at, request, report);
  else
    go_the_ways(at, request, report);
}

/// By how much two sets of forces differ that the same motion admits, and where most. Collective.
void ContactSolver::tell_undetermined(const PointField& found, const PointField& split, NewtonReport& report) const {
  const auto apart = [&, n = problem_.components()](int k) {
    double size = 0;
    for (int c = 0; c < n; ++c) size = std::max(size, std::abs(split[n * k + c] - found[n * k + c]));
    return size;
  };
  double largest = 0;
  for (int k = 0; k < problem_.owned_points(); ++k) largest = std::max(largest, apart(k));
  largest = largest_over_ranks(problem_, largest);
  double first = std::numeric_limits<double>::infinity();
  for (int k = 0; k < problem_.owned_points(); ++k)
    if (largest > 0 && apart(k) == largest) first = std::min(first, static_cast<double>(problem_.number_of(k)));
  first = -largest_over_ranks(problem_, -first);
  report.undetermined = largest / force_scale(problem_, found);
  report.undetermined_at = largest > 0 ? static_cast<long long>(first) : -1;
}

/// What is left to do where contact conditions are closed.
void ContactSolver::finish(const Iterate& at, const ContactRequest& request, NewtonReport& report) {
  leave_the_way(at, request, report);
  if (report.stopped) return;
  split_forces(at, request, report);
  if (report.stopped) return;
  const bool at_round_off = measure(at, request.strength, report) == 0;
  const double left = std::max(report.residual, report.complementarity);
  report.round_off = at_round_off && left > request.tolerance ? left : 0;
}

NewtonReport ContactSolver::solve(const Iterate& at, const ContactRequest& request) {
  NewtonReport report;
  if (!anything_selected(problem_)) {
    solve_linear(at, request, report);
  } else if (measure(at, request.strength, report) <= request.tolerance) {
    report.outcome = NewtonOutcome::converged;  // nothing has moved
  } else {
    auto end = ActiveSetEnd::circled;
    const bool fast = may_be_fast();
    if (fast) end = try_active_set(at, request, methods_.active_set.patience, report);
    if (end == ActiveSetEnd::arrived) {
      fast_ = {};
    } else if (!report.stopped) {
      if (fast) fast_.offered = end == ActiveSetEnd::circled;
      report.hard = methods_.solver.active_sets && !parameters_.time_follows;
      go_the_hard_way(at, request, report);
    }
  }
  if (report.outcome == NewtonOutcome::converged && !report.stopped) {
    finish(at, request, report);
  } else if (report.failed_solves > 0) {
    report.reason += "; " + std::to_string(report.failed_solves) + " of " +
                     counted(report.newton_iterations, "linear solve") + " failed, at last as " + report.failure;
  }
  if (report.stopped) report.outcome = NewtonOutcome::stopped;
  return report;
}

}  // namespace voussoir
