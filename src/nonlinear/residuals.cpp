#include "nonlinear/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/reduce.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

double largest_over_ranks(const NonlinearProblem& problem, double local) {
  return largest_over_ranks(*problem.map()->getComm(), local);
}

bool anything_selected(const NonlinearProblem& problem) {
  const auto& selected = problem.selected();
  return largest_over_ranks(problem, std::find(selected.begin(), selected.end(), 1) != selected.end()) > 0;
}

double force_scale(const NonlinearProblem& problem, const PointField& lambda) {
  double scale = problem.force_scale();
  // What tied points bore when it was recovered last counts too: equilibrium is no better than round-off of that.
  for (int k = 0; k < problem.points(); ++k) scale = std::max(scale, std::abs(lambda[k * problem.components()]));
  scale = largest_over_ranks(problem, scale);
  return scale > 0 ? scale : std::numeric_limits<double>::min();
}

void lawful_forces(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& lambda,
                   const PointField& gap, PointField& lawful) {
  PointField trial;
  std::vector<double> bound;
  trial_forces(problem, lambda, gap, 1.0, trial);
  friction_bounds(problem, laws, lambda, bound);
  project(problem, laws, trial, bound, lawful);
}

double contact_residual(const NonlinearProblem& problem, const CurrentLaws& laws, const PointField& lambda,
                        const PointField& gap) {
  const int n = problem.components();
  PointField lawful;
  lawful_forces(problem, laws, lambda, gap, lawful);
  double worst = 0;
  for (int k = 0; k < problem.owned_points(); ++k)
    if (problem.selected()[k])
      for (int c = k * n; c < (k + 1) * n; ++c) {
        const double off = std::abs(lawful[c] - lambda[c]);
        worst = std::isnan(off) ? std::numeric_limits<double>::infinity() : std::max(worst, off);
      }
  return largest_over_ranks(problem, worst);
}

Imbalance imbalance(NonlinearProblem& problem, const CurrentLaws& laws, const PointField& lambda, const PointField& gap,
                    TpetraVector& residual) {
  problem.subtract_contact_forces(lambda, residual);
  return {residual.normInf(), contact_residual(problem, laws, lambda, gap)};
}

double size_of(const NonlinearProblem& problem, double equilibrium, double contact, double scale) {
  const double larger = std::max(contact, equilibrium);
  return larger <= problem.round_off() ? 0 : larger / scale;
}

double judge_state(NonlinearProblem& problem, Strength strength, const TpetraVector& x, const PointField& lambda,
                   TpetraVector& residual, PointField& gap, NewtonReport& report) {
  problem.evaluate(x, residual, gap);
  const CurrentLaws laws(problem, strength, lambda, gap);
  const auto [equilibrium, contact] = imbalance(problem, laws, lambda, gap, residual);
  const double scale = force_scale(problem, lambda);
  report.residual = equilibrium / scale;
  report.complementarity = contact / scale;
  return size_of(problem, equilibrium, contact, scale);
}

}  // namespace voussoir
