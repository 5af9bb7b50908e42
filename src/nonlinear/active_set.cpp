#include "nonlinear/active_set.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

// What closed points resist with, relative to their local stiffness. On the bridge in its earthquake (README.md) 100
// takes 10 solves a step, because forces creep at vertices, 1000 takes 5.4 and 10^4 takes 6.5.
constexpr double augmentation = 1000;
// Of linear solves. What one leaves open looks like points that change: with 1e-2 near the end the first 0.9 s of the
// bridge in its earthquake took 2028 solves and 14416 Krylov iterations, with 1e-4 911 and 5366.
constexpr double accuracy = 1e-4;
// So many solves that gain less than half: it circles.
constexpr int patience = 8;
constexpr double gained = 0.5;

}  // namespace

ActiveSet::ActiveSet(NonlinearProblem& problem) : problem_(problem), sliding_(problem.points()) {
  VOUSSOIR_EXPECT(problem.components() == 2);
  for (auto* v : {&linear_, &gradient_, &direction_}) *v = Teuchos::rcp(new TpetraVector(problem.map()));
}

/// Statuses that forces and gaps ask for. No point turns from one direction of slip to the other: between them it
/// sticks.
void ActiveSet::choose(const PointField& lambda, const PointField& gap) {
  resistance_.assign(problem_.points(), {});
  const auto before = std::exchange(sliding_, std::vector<double>(problem_.points(), 0.0));
  for (int k = 0; k < problem_.points(); ++k) {
    if (!problem_.selected()[k]) continue;
    const auto& law = problem_.law()[k];
    const auto trial = [&](int c) {
      return lambda[2 * k + c] - stiffness_of(problem_, k, c, 1.0) * motion_of(problem_, k, c, gap, lambda);
    };
    const double p = trial(0), q = trial(1);
    if (!(p > -law.tension)) continue;
    auto& r = resistance_[k];
    r.normal = stiffness_of(problem_, k, 0, augmentation);
    const double bound = friction_bound(law, p);
    const double direction = q < 0 ? -1 : 1;
    if (std::abs(q) < bound || (bound > 0 && direction == -before[k])) {
      r.tangential = stiffness_of(problem_, k, 1, augmentation);
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
  project(problem_, lambda, bound, admissible_);
  Tpetra::deep_copy(*gradient_, *linear_);
  const auto [equilibrium, contact] = imbalance(problem_, admissible_, gap_, *gradient_);
  scale_ = force_scale(problem_, admissible_);
  report.residual = equilibrium / scale_;
  report.complementarity = contact / scale_;
  return std::max(report.residual, report.complementarity);
}

bool ActiveSet::solve(TpetraVector& x, PointField& lambda, double tolerance, int largest_solves,
                      const PointField* known_gap, NewtonReport& report) {
  problem_.evaluate(x, *linear_, gap_);
  double best = std::numeric_limits<double>::infinity();
  for (int solves = 1, last_gain = 1; solves <= largest_solves && solves < last_gain + patience; ++solves) {
    choose(lambda, known_gap && solves == 1 ? *known_gap : gap_);
    aim(lambda);
    Tpetra::deep_copy(*gradient_, *linear_);
    problem_.subtract_contact_forces(target_, *gradient_);
    gradient_->scale(-1.0);
    direction_->putScalar(0);
    const int krylov = problem_.solve(resistance_, 0.0, gradient_, direction_, accuracy);
    report.count(krylov);
    problem_.evaluate_direction(*direction_, *gradient_, gap_direction_);
    x.update(1.0, *direction_, 1.0);
    lambda = target_;
    for (int k = 0; k < problem_.points(); ++k) {
      if (!problem_.selected()[k]) continue;
      const auto& r = resistance_[k];
      lambda[2 * k] -= r.normal * gap_direction_[2 * k];
      lambda[2 * k + 1] -= r.tangential * gap_direction_[2 * k + 1] + r.coupling * gap_direction_[2 * k];
    }
    const double size = measure(x, lambda, report);
    tell(report, krylov);
    if (size <= tolerance) {
      lambda = admissible_;
      report.outcome = NewtonOutcome::converged;
      return true;
    }
    if (!std::isfinite(size)) return false;
    if (size > gained * best) continue;
    best = size;
    last_gain = solves;
  }
  return false;
}

void ActiveSet::tell(const NewtonReport& report, int krylov) const {
  long long mine[2] = {0, 0}, all[2];
  for (int k = 0; k < problem_.owned_points(); ++k) {
    if (!problem_.selected()[k]) continue;
    mine[0] += resistance_[k].normal > 0;
    mine[1] += sliding_[k] != 0;
  }
  Teuchos::reduceAll(*problem_.map()->getComm(), Teuchos::REDUCE_SUM, 2, mine, all);  // all ranks, listening or not
  if (!narrate) return;
  narrate({report.newton_iterations, report.residual * scale_, report.complementarity * scale_, all[0], all[1], krylov,
           1.0, augmentation});
}

}  // namespace voussoir
