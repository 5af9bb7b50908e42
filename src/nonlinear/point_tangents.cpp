#include "nonlinear/point_tangents.hpp"

#include <algorithm>
#include <cmath>

#include "nonlinear/stability_parameters.hpp"

namespace voussoir {
namespace {

using Numbers = StabilityParameters;

/// Of length one; the first tangent where there is none.
InTangents direction_of(const InTangents& a) {
  const double size = std::hypot(a[0], a[1]);
  return size > 0 ? InTangents{a[0] / size, a[1] / size} : InTangents{1, 0};
}

/// f(a) of a symmetric matrix.
template <class Function>
Square function_of(const Square& a, const Function& f) {
  if (a[1] == 0) return {f(a[0]), 0.0, f(a[2])};
  const double middle = (a[0] + a[2]) / 2, half = (a[0] - a[2]) / 2, radius = std::hypot(half, a[1]);
  const double high = f(middle + radius), low = f(middle - radius);
  const double mean = (high + low) / 2, slope = (high - low) / (2 * radius);
  return {mean + slope * half, slope * a[1], mean - slope * half};
}

/// Derivative of the forces of a point along its normal and its shear, with friction held at its size: symmetric part.
struct PointDerivative {
  Square value;
  InTangents along;   ///< direction of the shear
  double across = 0;  ///< [N/m] against motion across it
};

PointDerivative derivative(const NonlinearProblem& problem, int k, const WeakenedLaw& now, const PointField& lambda,
                           const PointField& gap) {
  const int tangents = problem.components() - 1;
  const double* const force = &lambda[static_cast<std::size_t>(k) * problem.components()];
  const double opening = motion_of(problem, k, 0, gap, lambda), sigma = stiffness_of(problem, k, 1, 1.0);
  const auto slip = slip_of(problem, k, lambda, gap);
  const double normal = force[0] - stiffness_of(problem, k, 0, 1.0) * opening;
  InTangents trial{};
  for (int t = 0; t < tangents; ++t) trial[t] = force[t + 1] - sigma * slip[t];
  const double shear = std::hypot(trial[0], trial[1]);
  const bool open = judge(now.law, normal, 0.0, 0.0) == ContactStatus::open;
  const double bound = friction_bound(now.law, open ? -now.law.tension : normal);
  const bool sticks = bound > 0 && shear<bound, slips = bound> 0 && !sticks;
  const bool advances = slips && component(trial, slip.data(), tangents) <= 0;
  PointStiffness s;
  PointCompliance mortar = problem.compliance().empty() ? PointCompliance{} : problem.compliance()[k];
  s.normal = open ? now.pull_per_opening : stiffness_of(problem, k, 0, Numbers::augmentation);
  if (!open) mortar.normal = 0;  // which is in it
  const double stuck = stiffness_of(problem, k, 1, Numbers::augmentation);
  if (sticks) {
    s.hold(0, stuck);
    mortar.tangential = 0;
  } else if (slips) {
    // Across the slip the shear turns, as in the active set.
    const double share = std::min(bound / shear, 1.0);
    s.tangential = {advances ? now.cohesion_per_slip : 0.0, 0, std::min(stuck, sigma * share / (1 - share))};
  }
  double mixed = 0;
  if (open && advances) mixed = -(now.pull_per_slip + now.cohesion_per_gap) / 2;
  s.coupling[0] = s.pull[0] = mixed;
  if (mortar.normal != 0 || mortar.tangential != 0) s = in_series(s, mortar, problem.components());
  return {{s.normal, (s.coupling[0] + s.pull[0]) / 2, s.tangential[0]}, direction_of(trial), s.tangential[2]};
}

}  // namespace

InTangents slip_of(const NonlinearProblem& problem, int k, const PointField& lambda, const PointField& gap) {
  InTangents slip{};
  for (int c = 1; c < problem.components(); ++c) slip[c - 1] = motion_of(problem, k, c, gap, lambda);
  return slip;
}

std::vector<PointTangent> point_tangents(const NonlinearProblem& problem, const CurrentLaws& laws,
                                         const PointField& lambda, const PointField& gap) {
  const int tangents = problem.components() - 1;
  std::vector<PointTangent> all(problem.points());
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k]) continue;
    const auto d = derivative(problem, k, laws.at(k), lambda, gap);
    auto& t = all[k];
    const Square size = function_of(d.value, [](double value) { return std::abs(value); });
    t.resistance.normal = size[0];
    t.resistance.slide(d.along.data(), tangents, size[1], d.across, size[2], size[1]);
    t.softening = function_of(d.value, [](double value) { return std::sqrt(std::max(0.0, -value)); });
    t.softens = t.softening[0] > 0 || t.softening[2] > 0;
    t.along = d.along;
    t.onward = direction_of(slip_of(problem, k, lambda, gap));
  }
  return all;
}

}  // namespace voussoir
