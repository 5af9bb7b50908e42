#include "nonlinear/residuals.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "nonlinear/point_update.hpp"

namespace voussoir {

double largest_over_ranks(const NonlinearProblem& problem, double local) {
  double global = 0;
  Teuchos::reduceAll(*problem.map()->getComm(), Teuchos::REDUCE_MAX, local, Teuchos::outArg(global));
  return global;
}

double force_scale(const NonlinearProblem& problem, const PointField& lambda) {
  double scale = problem.force_scale();
  for (int k = 0; k < problem.points(); ++k)
    if (problem.selected()[k]) scale = std::max(scale, std::abs(lambda[k * problem.components()]));
  scale = largest_over_ranks(problem, scale);
  return scale > 0 ? scale : std::numeric_limits<double>::min();
}

double contact_residual(const NonlinearProblem& problem, const PointField& lambda, const PointField& gap) {
  const int n = problem.components();
  PointField trial, admissible;
  std::vector<double> bound;
  trial_forces(problem, lambda, gap, 1.0, trial);
  friction_bounds(problem, lambda, bound);
  project(problem, trial, bound, admissible);
  double worst = 0;
  for (int k = 0; k < problem.owned_points(); ++k)
    if (problem.selected()[k])
      for (int c = k * n; c < (k + 1) * n; ++c) worst = std::max(worst, std::abs(admissible[c] - lambda[c]));
  return largest_over_ranks(problem, worst);
}

}  // namespace voussoir
