#include "nonlinear/contact_solver.hpp"

#include <algorithm>

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

double ContactSolver::out_of_balance(const TpetraVector& x, const PointField& lambda) const {
  TpetraVector residual(problem_.map());
  PointField gap;
  problem_.evaluate(x, residual, gap);
  const auto [equilibrium, contact] = imbalance(problem_, lambda, gap, residual);
  return std::max(equilibrium, contact);
}

bool ContactSolver::in_equilibrium(const TpetraVector& x, const PointField& lambda, double tolerance) const {
  return out_of_balance(x, lambda) <= tolerance * force_scale(problem_, lambda);
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
                                           const PointField* known_gap, int largest_solves, int patience,
                                           NewtonReport& report) {
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  ActiveSet active(problem_, parameters_.has_inertia ? ActiveSetUse::in_time : ActiveSetUse::at_rest, methods_,
                   patience);
  active.narrate = narrate;
  const int most = std::min(largest_solves, parameters_.largest_iterations);
  const auto end = active.solve(x, lambda, tolerance, most, known_gap, report);
  if (end != ActiveSetEnd::arrived) {
    before.restore(x);
    lambda = lambda_before;
  }
  return end;
}

const PointField* ContactSolver::along_the_path(TpetraVector& x, PointField& lambda, double tolerance,
                                                const PointField* known_gap, bool shortcut, NewtonReport& report) {
  if (!path_ || !methods_.path.used) return known_gap;
  InteriorPath interior(problem_, methods_);
  interior.narrate = narrate;
  if (shortcut)
    interior.shortcut = [&](TpetraVector& near_x, PointField& near_lambda) {
      return try_active_set(near_x, near_lambda, tolerance, nullptr, methods_.solver.solves_from_near,
                            methods_.solver.patience_from_near, report) == ActiveSetEnd::arrived;
    };
  const int steps = std::min(methods_.solver.largest_path, parameters_.largest_iterations - report.newton_iterations);
  const SavedPosition before(problem_, x);
  const PointField lambda_before = lambda;
  const double off_before = out_of_balance(x, lambda);
  const auto end = interior.follow(x, lambda, tolerance, steps, known_gap, report);
  if (end == PathEnd::stuck && out_of_balance(x, lambda) > off_before) {
    before.restore(x);
    lambda = lambda_before;
  } else if (end != PathEnd::ran_away) {
    return nullptr;
  }
  ++led_nowhere_;
  return known_gap;
}

NewtonReport ContactSolver::solve(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap) {
  NewtonReport report;
  path_ = problem_.components() == 2 && anything_selected(problem_);
  if (in_equilibrium(x, lambda, tolerance)) {
    known_gap = nullptr;  // nothing has moved: closing only measures
  } else if (path_) {
    if (may_be_fast()) {
      const int most = parameters_.has_inertia ? methods_.solver.solves_in_time : methods_.solver.solves_at_rest;
      const auto end = try_active_set(x, lambda, tolerance, known_gap, most, methods_.active_set.patience, report);
      if (end == ActiveSetEnd::arrived) {
        fast_ = {};
        return report;
      }
      fast_.offered = end == ActiveSetEnd::circled;
    }
    const bool shortcut = methods_.solver.shortcut && fast_.offered && !parameters_.time_follows;
    known_gap = along_the_path(x, lambda, tolerance, known_gap, shortcut, report);
  }
  // Where closing labours, another path from the state it has reached is shorter.
  for (bool last = false;; known_gap = along_the_path(x, lambda, tolerance, nullptr, false, report)) {
    const int left = parameters_.largest_iterations - report.newton_iterations;
    const int most = methods_.solver.closing_solves << std::min(led_nowhere_, methods_.solver.most_doublings);
    last = left <= most;
    NewtonParameters some = parameters_;
    some.largest_iterations = std::max(1, last ? left : most);
    AugmentedLagrangian closing(problem_, some, methods_.closing);
    const int before = report.newton_iterations;
    closing.narrate = [&](NewtonProgress p) {
      p.iteration += before;
      if (narrate) narrate(p);
    };
    report.add(closing.solve(x, lambda, tolerance, known_gap));
    Tpetra::deep_copy(*mechanism_, closing.mechanism());
    if (report.outcome != NewtonOutcome::not_converged) return report;
    if (!last && methods_.closing.used && !report.no_way_on) continue;
    if (report.failed_solves > 0)
      report.reason += "; " + std::to_string(report.failed_solves) + " of " +
                       std::to_string(report.newton_iterations) + " linear solves failed, at last as " + report.failure;
    return report;
  }
}

}  // namespace voussoir
