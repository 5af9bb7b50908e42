#include "nonlinear/augmented_lagrangian.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/local_view.hpp"
#include "nonlinear/line_search.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/rigid_mechanism.hpp"

namespace voussoir {

struct AugmentedLagrangian::State {
  State(TpetraVector& unknowns, PointField& forces_in, double first_proximal)
      : x(unknowns), lambda(forces_in), proximal(first_proximal) {}

  TpetraVector& x;
  PointField& lambda;
  Teuchos::RCP<TpetraVector> x_old, gradient, direction, stiffness_direction, linear;
  PointField gap, gap_direction, trial, forces, pressure;
  std::vector<double> bound;
  std::vector<PointStiffness> resistance, colliding;
  double augmentation = 1, proximal;
  double scale = 1;  // [N]
  int krylov_last = 0;
  bool refused = false;  // a library would not solve the last system
  int following = 0;  // Newton steps whose friction bounds follow the pressure
  bool linear_only = false;  // no point is selected
  double inner_residual = 0;
};

AugmentedLagrangian::AugmentedLagrangian(NonlinearProblem& problem, const NewtonParameters& parameters,
                                         const AugmentedLagrangianParameters& numbers)
    : problem_(problem),
      parameters_(parameters),
      numbers_(numbers),
      mechanism_(Teuchos::rcp(new TpetraVector(problem.map()))) {}

/// direction = -(K + resistance + proximal)^-1 gradient.
void AugmentedLagrangian::solve_direction(State& s, double relative_tolerance, NewtonReport& report) {
  s.gradient->scale(-1.0);
  s.direction->putScalar(0);
  const auto solved = problem_.solve(s.resistance, s.proximal, s.gradient, s.direction, {relative_tolerance});
  report.count(solved);
  s.krylov_last = solved.iterations;
  s.refused = solved.nothing;
}

/// Step along the direction that minimises the augmented function with its friction bounds held.
double AugmentedLagrangian::line_search(State& s) {
  const int n = problem_.components();
  const auto& weight = problem_.proximal_weight();
  const auto& comm = *problem_.map()->getComm();
  problem_.evaluate_direction(*s.direction, *s.stiffness_direction, s.gap_direction);
  const double slope_linear = s.direction->dot(*s.linear);
  double proximal = 0, proximal_all = 0;
  const double* d = local_view(*s.direction);
  for (std::size_t i = 0; i < weight.size(); ++i) proximal += s.proximal * weight[i] * d[i] * d[i];
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, proximal, Teuchos::outArg(proximal_all));
  const double curvature = s.direction->dot(*s.stiffness_direction) + proximal_all;
  PointField moved(s.trial.size()), forces;
  return exact_step([&](double alpha) {
    for (int k = 0; k < problem_.owned_points(); ++k) {
      for (int c = k * n; c < (k + 1) * n; ++c)
        moved[c] = s.trial[c] - alpha * stiffness_of(problem_, k, c - k * n, s.augmentation) * s.gap_direction[c];
    }
    project(problem_, moved, s.bound, forces);
    double work = 0, all = 0;
    for (int k = 0; k < problem_.owned_points(); ++k)
      if (problem_.selected()[k])
        for (int c = k * n; c < (k + 1) * n; ++c) work += s.gap_direction[c] * forces[c];
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, work, Teuchos::outArg(all));
    return slope_linear + alpha * curvature - all;
  });
}

/// One linear step with the statuses of a known state of equilibrium: what moves are supports and loads alone.
void AugmentedLagrangian::predict(State& s, const PointField& known_gap, NewtonReport& report) {
  const int n = problem_.components();
  trial_forces(problem_, s.lambda, known_gap, s.augmentation, s.trial);
  friction_bounds(problem_, s.lambda, s.bound);
  resistances(problem_, s.trial, s.bound, s.augmentation, s.resistance);
  problem_.evaluate(s.x, *s.gradient, s.gap);
  s.forces = s.lambda;
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    for (int c = 0; c < n; ++c) {
      const double stiffness = c == 0 ? s.resistance[k].normal : s.resistance[k].tangential;
      s.forces[k * n + c] -= stiffness * (s.gap[k * n + c] - known_gap[k * n + c]);
    }
  }
  problem_.subtract_contact_forces(s.forces, *s.gradient);
  solve_direction(s, numbers_.prediction, report);
  s.x.update(1.0, *s.direction, 1.0);
}

/// Points that gave way at the start of a direction and would resist at its end.
void AugmentedLagrangian::anticipate(State& s) const {
  PointField end(s.trial.size());
  const int n = problem_.components();
  for (int k = 0; k < problem_.points(); ++k) {
    for (int c = k * n; c < (k + 1) * n; ++c)
      end[c] = s.trial[c] - stiffness_of(problem_, k, c - k * n, s.augmentation) * s.gap_direction[c];
  }
  resistances(problem_, end, s.bound, s.augmentation, s.colliding);
}

/// Semismooth Newton on the augmented function with contact forces held; returns the number of linear solves.
int AugmentedLagrangian::minimise(State& s, double tolerance, NewtonReport& report) {
  const auto& weight = problem_.proximal_weight();
  const auto& comm = *problem_.map()->getComm();
  s.colliding.assign(problem_.points(), {});
  for (int solves = 0;; ++solves) {
    problem_.evaluate(s.x, *s.linear, s.gap);
    {
      const double* x = local_view(s.x);
      const double* old = local_view(*s.x_old);
      double* r = local_view_to_write(*s.linear);
      for (std::size_t i = 0; i < weight.size(); ++i) r[i] += s.proximal * weight[i] * (x[i] - old[i]);
    }
    trial_forces(problem_, s.lambda, s.gap, s.augmentation, s.trial);
    // Held friction bounds leave a convex function, whose minimum Newton must find. Where forces creep or circle,
    // bounds that follow the pressure get them out.
    friction_bounds(problem_, solves < s.following ? s.trial : s.pressure, s.bound);
    project(problem_, s.trial, s.bound, s.forces);
    Tpetra::deep_copy(*s.gradient, *s.linear);
    problem_.subtract_contact_forces(s.forces, *s.gradient);
    s.inner_residual = s.gradient->normInf();
    if (s.inner_residual < tolerance || report.newton_iterations >= parameters_.largest_iterations ||
        solves >= numbers_.largest_inner)
      return solves;

    resistances(problem_, s.trial, s.bound, s.augmentation, s.resistance);
    for (std::size_t k = 0; k < s.colliding.size(); ++k) {
      s.resistance[k].normal = std::max(s.resistance[k].normal, s.colliding[k].normal);
      s.resistance[k].tangential = std::max(s.resistance[k].tangential, s.colliding[k].tangential);
    }
    // No more accurate than Newton can use: a tenth of what this minimisation aims at. Where one solve is all, its norm
    // bounds the largest residual.
    const double accuracy =
        s.linear_only ? std::clamp(tolerance / s.gradient->norm2(), numbers_.finest_alone, numbers_.coarsest_accuracy)
                      : std::clamp(numbers_.solve_aim * tolerance / s.inner_residual, numbers_.finest_accuracy,
                                   numbers_.coarsest_accuracy);
    solve_direction(s, accuracy, report);
    if (s.refused) return solves;
    const double step = line_search(s);
    s.x.update(step, *s.direction, 1.0);
    s.colliding.assign(problem_.points(), {});
    if (step < numbers_.collision_step) anticipate(s);

    long long mine[2] = {0, 0}, all[2];
    for (int k = 0; k < problem_.owned_points(); ++k)
      if (problem_.selected()[k] && s.resistance[k].normal > 0) {
        ++mine[0];
        mine[1] += s.resistance[k].tangential == 0;
      }
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 2, mine, all);  // also where nobody listens: all ranks must agree
    if (narrate)
      narrate({report.newton_iterations, s.inner_residual, report.complementarity * s.scale, all[0], all[1],
               s.krylov_last, step, s.augmentation});
  }
}

/// Takes the projected trial forces as the new contact forces; returns the largest change [N].
double AugmentedLagrangian::update_forces(State& s) const {
  double change = 0;
  const int n = problem_.components();
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    for (int c = k * n; c < (k + 1) * n; ++c) {
      if (k < problem_.owned_points()) change = std::max(change, std::abs(s.forces[c] - s.lambda[c]));
      s.lambda[c] = s.forces[c];
    }
  }
  return largest_over_ranks(problem_, change);
}

/// Karush-Kuhn-Tucker residuals of the true problem: no proximal term, augmentation 1.
void AugmentedLagrangian::measure(State& s, NewtonReport& report) const {
  problem_.evaluate(s.x, *s.gradient, s.gap);
  const auto [equilibrium, contact] = imbalance(problem_, s.lambda, s.gap, *s.gradient);
  report.residual = equilibrium / s.scale;
  report.complementarity = contact / s.scale;
  double penetration = 0;
  for (int k = 0; k < problem_.owned_points(); ++k)
    if (problem_.selected()[k]) {
      const int normal = k * problem_.components();
      penetration = std::max(penetration, -s.gap[normal] - compliance_of(problem_, k, 0) * s.lambda[normal]);
    }
  report.penetration = largest_over_ranks(problem_, penetration);
}

/// Has the last update moved something by a share of the structure?
bool AugmentedLagrangian::moved_far(State& s) const {
  mechanism_->update(1.0, s.x, -1.0, *s.x_old, 0.0);
  return mechanism_->normInf() > numbers_.run_away * problem_.length_scale();
}

/// Does the motion of the last update lead nowhere? Far along it forces and imbalance must be as they are here: nothing
/// stiffens, opens or closes. The test does not wait until round-off (Young's modulus x motion) hides the imbalance.
/// Expects the gradient and the gaps that measure() leaves.
bool AugmentedLagrangian::runs_away(State& s) const {
  mechanism_->update(1.0, s.x, -1.0, *s.x_old, 0.0);
  const double size = mechanism_->normInf(), far = numbers_.run_away * problem_.length_scale();
  if (!(size > 0)) return false;
  mechanism_->scale(1 / size);
  if (size >= far) return true;
  const double allowance = numbers_.unchanged * s.gradient->normInf();
  if (!parameters_.has_inertia && is_rigid_mechanism(problem_, *mechanism_, s.lambda, s.gap, far, allowance))
    return true;
  s.direction->update(1.0, s.x, far, *mechanism_, 0.0);
  problem_.evaluate(*s.direction, *s.linear, s.gap);
  problem_.subtract_contact_forces(s.lambda, *s.linear);
  s.linear->update(-1.0, *s.gradient, 1.0);
  return s.linear->normInf() <= allowance && contact_residual(problem_, s.lambda, s.gap) <= allowance;
}

NewtonReport AugmentedLagrangian::solve(TpetraVector& x, PointField& lambda, double tolerance,
                                        const PointField* known_gap) {
  NewtonReport report;
  State s{x, lambda, numbers_.largest_proximal};
  for (auto* v : {&s.x_old, &s.gradient, &s.direction, &s.stiffness_direction, &s.linear})
    *v = Teuchos::rcp(new TpetraVector(problem_.map()));
  double previous = std::numeric_limits<double>::infinity();
  double change = 0;
  s.pressure = lambda;
  s.linear_only = !anything_selected(problem_);
  int stagnant = 0, drifting = 0;
  double last_residual = 0;
  double relaxation = 1;
  for (report.outer_iterations = 1;; ++report.outer_iterations) {
    s.scale = force_scale(problem_, lambda);
    const bool first = report.outer_iterations == 1;
    const bool closes = numbers_.used || s.linear_only;
    if (first && known_gap && closes) predict(s, *known_gap, report);
    problem_.carry(x, tolerance * s.scale);
    Tpetra::deep_copy(*s.x_old, x);
    if (first) {
      measure(s, report);
      change = std::max(report.residual, report.complementarity) * s.scale;
      if (report.residual <= tolerance && report.complementarity <= tolerance) break;
    }
    if (!closes) {
      report.reason = "the augmented Lagrangian is switched off, and nothing else has closed the contact conditions";
      return report;
    }
    // Without contact one linear solve is the answer, so it is made as accurate as that.
    const double aim =
        s.linear_only ? tolerance * s.scale : std::max(numbers_.aim * tolerance * s.scale, numbers_.aim * change);
    const int solves = minimise(s, aim, report);
    if (s.refused) {
      report.reason = "a linear system has no solution";
      report.no_way_on = true;
      return report;
    }
    change = update_forces(s);
    measure(s, report);
    if (report.residual <= tolerance && report.complementarity <= tolerance) break;
    // Only where forces have settled and the imbalance stays: early iterations may look like anything.
    drifting = report.complementarity < numbers_.settled * report.residual &&
                       report.residual > numbers_.drifting * last_residual
                   ? drifting + 1
                   : 0;
    last_residual = report.residual;
    // Stones in flight collide: where forces do not obey the contact law, a motion proves nothing, however far it went.
    const bool believed = report.complementarity < numbers_.believable;
    if (believed && (drifting > numbers_.drifting_steps || moved_far(s)) && runs_away(s)) {
      report.outcome = NewtonOutcome::collapse;
      report.reason = "the structure moves without end: no equilibrium exists under this load";
      return report;
    }
    if (report.newton_iterations >= parameters_.largest_iterations ||
        report.outer_iterations >= parameters_.largest_iterations) {
      report.reason = "the largest number of linear solves was reached";
      return report;
    }
    stagnant = change > numbers_.stagnating * previous && solves <= numbers_.struggling ? stagnant + 1 : 0;
    const bool stagnates = stagnant > numbers_.stagnant_steps;
    const bool creeps = (solves <= 1 && change > numbers_.creeping * previous) || stagnates;
    if (stagnates) stagnant = 0;
    // Pressures that go in circles take friction bounds with them: let the bounds follow half way for a while.
    relaxation = creeps ? numbers_.relaxation : 1.0;
    for (std::size_t i = 0; i < lambda.size(); ++i) s.pressure[i] += relaxation * (lambda[i] - s.pressure[i]);
    previous = change;
    s.following = creeps ? numbers_.labouring : 0;
    if (creeps) {
      s.augmentation = std::min(numbers_.factor * s.augmentation, numbers_.largest_augmentation);
      s.proximal = std::max(s.proximal / numbers_.factor, numbers_.smallest_proximal);
    } else if (solves > numbers_.struggling) {
      s.augmentation = std::max(s.augmentation / numbers_.factor, 1.0);
      s.proximal = std::min(s.proximal * numbers_.factor, numbers_.largest_proximal);
    }
  }
  report.outcome = NewtonOutcome::converged;
  return report;
}

}  // namespace voussoir
