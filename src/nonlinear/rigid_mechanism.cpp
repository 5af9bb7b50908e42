#include "nonlinear/rigid_mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nonlinear/residuals.hpp"

namespace voussoir {
namespace {

// Share of a motion that may be deformation, or closing of what presses: linear solves leave 1e-8.
constexpr double deformation = 1e-6;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// By how much the law would change the force of a point at the end of the motion [N].
/// @param gap      [m] at the end, beyond what the force itself makes of it
/// @param slip     [m] along the motion, tangential components
/// @param nothing  [m] motions below this are none
double change_of_force(const PointLaw& law, const double* force, int components, double gap, const double* slip,
                       double nothing) {
  if (gap < -nothing) return infinite;
  const double normal = gap > nothing ? -law.tension : force[0];
  const double bound = friction_bound(law, normal);
  const auto size = [components](const double* v) {
    double squares = 0;
    for (int c = 0; c + 1 < components; ++c) squares += v[c] * v[c];
    return std::sqrt(squares);
  };
  const double slid = size(slip), friction = size(force + 1);
  if (slid <= nothing) return std::max(std::abs(normal - force[0]), friction - bound);
  if (bound == infinite) return infinite;
  double change = std::abs(normal - force[0]);
  for (int c = 0; c + 1 < components; ++c) change = std::max(change, std::abs(-bound * slip[c] / slid - force[1 + c]));
  return change;
}

}  // namespace

bool is_rigid_mechanism(NonlinearProblem& problem, const CurrentLaws& laws, const TpetraVector& motion,
                        const PointField& lambda, const PointField& gap, double far, double allowance) {
  const int n = problem.components();
  PointField moved;
  if (!(problem.rigid_gaps(motion, moved) <= deformation)) return false;
  double worst = 0;
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    for (int c = k * n; c < (k + 1) * n; ++c) moved[c] *= far;
    // What presses is closed, whatever round-off of a stiff block makes of its gap.
    const double before = lambda[k * n] > allowance ? 0.0 : std::max(0.0, motion_of(problem, k, 0, gap, lambda));
    worst = std::max(worst, change_of_force(laws[k], &lambda[k * n], n, before + moved[k * n], &moved[k * n + 1],
                                            deformation * far));
  }
  return largest_over_ranks(problem, worst) <= allowance;
}

}  // namespace voussoir
