#include "nonlinear/parted_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "linalg/reduce.hpp"
#include "nonlinear/point_tangents.hpp"
#include "nonlinear/point_update.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/stability_parameters.hpp"

namespace voussoir {
namespace {

using Numbers = StabilityParameters;

/// A state seen from its points.
struct SeenState {
  PointField gap;
  Damage worn;  ///< what each point has gone through there
};

SeenState see(NonlinearProblem& problem, const Iterate& at, StrengthIs strength = StrengthIs::falling) {
  SeenState seen;
  TpetraVector residual(problem.map());
  problem.evaluate(at.x, residual, seen.gap);
  seen.worn = wear(problem, {&at.damage, strength}, at.lambda, seen.gap).damage;
  return seen;
}

double slipped(const NonlinearProblem& problem, int k, const PointField& lambda, const PointField& gap) {
  const auto slip = slip_of(problem, k, lambda, gap);
  return std::hypot(slip[0], slip[1]);
}

/// [J] that one point holds or has taken since the start of the step.
double taken_by(const NonlinearProblem& problem, int k, const SeenState& seen, const PointField& lambda) {
  const int n = problem.components();
  double taken = 0;
  for (int c = 0; c < n; ++c) taken += compliance_of(problem, k, c) * lambda[n * k + c] * lambda[n * k + c] / 2;
  const auto& softening = *problem.softening();
  if (!softening.softens(k)) return taken;
  return taken + energy_taken(softening[k], seen.worn[k], motion_of(problem, k, 0, seen.gap, lambda), lambda[n * k]);
}

}  // namespace

int parted_side_by_side(NonlinearProblem& problem, const Iterate& at) {
  const auto& softening = *problem.softening();
  const auto seen = see(problem, at);
  const int n = problem.components();
  std::map<int, int> first_of;  // of a joint, among the points that have come so far
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k] || !softening.softens(k)) continue;
    const auto point = softening[k];
    const auto growth = [&](double opened, double way) {
      return point.rate.growth(point.rate.kappa(std::max(point.before.opened, opened), point.before.slipped + way));
    };
    if (!(growth(seen.worn[k].opened, seen.worn[k].way) < growth(0, 0) / 2)) continue;
    const double strength = point.whole.tension > 0 ? point.whole.tension : point.whole.cohesion;
    const double taken =
        energy_taken(point, seen.worn[k], motion_of(problem, k, 0, seen.gap, at.lambda), at.lambda[n * k]);
    if (!(taken > strength * strength / (2 * problem.local_stiffness()[k]))) continue;
    auto& first = first_of.emplace(problem.joint_of(k), k).first->second;
    if (problem.number_of(k) < problem.number_of(first)) first = k;
  }
  int mine = 0;  // a joint is counted where its first point is owned
  for (const auto& [joint, first] : first_of) mine += first < problem.owned_points() ? 1 : 0;
  return total_over_ranks(*problem.map()->getComm(), mine);
}

FirstOfAlike wear_one_more(NonlinearProblem& problem, const Iterate& at, StrengthIs strength, LetCrack& cracks) {
  const auto& softening = *problem.softening();
  const auto seen = see(problem, at, strength);
  cracks.resize(problem.points(), 0);
  std::vector<double> gone(problem.points(), 0.0);
  for (int k = 0; k < problem.points(); ++k) {
    if (!problem.selected()[k] || !softening.softens(k) || cracks[k]) continue;
    const auto point = softening[k];
    if (lost(point, seen.worn[k]) - lost(point, at.damage[k]) <= Numbers::share_error) continue;
    const double opening = std::max(0.0, motion_of(problem, k, 0, seen.gap, at.lambda) + point.gap_before);
    gone[k] = point.rate.kappa(opening, point.before.slipped + slipped(problem, k, at.lambda, seen.gap));
  }
  const auto next = first_of_alike(problem, gone);
  for (int k = 0; k < problem.points(); ++k) {
    if (next.number >= 0 && problem.joint_of(k) == next.joint) cracks[k] = 1;
    if (cracks[k]) at.damage[k] = seen.worn[k];
  }
  return next;
}

PotentialBeyond potential_beyond(NonlinearProblem& problem, const Iterate& first, const Iterate& second) {
  const auto a = see(problem, first), b = see(problem, second);
  const int n = problem.components();
  PotentialBeyond sum;
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k]) continue;
    for (int c = 0; c < n; ++c) {
      const int i = n * k + c;
      sum.potential += (b.gap[i] - a.gap[i]) * (first.lambda[i] + second.lambda[i]) / 2;
    }
    const double taken_first = taken_by(problem, k, a, first.lambda);
    const double taken_second = taken_by(problem, k, b, second.lambda);
    const double friction = problem.law()[k].friction;
    const double pressed = std::max(0.0, first.lambda[n * k]) + std::max(0.0, second.lambda[n * k]);
    if (std::isfinite(friction))
      sum.potential += friction * pressed / 2 *
                       (slipped(problem, k, second.lambda, b.gap) - slipped(problem, k, first.lambda, a.gap));
    sum.potential += taken_second - taken_first;
    sum.taken += taken_first + taken_second;
  }
  const auto& comm = *problem.map()->getComm();
  return {total_over_ranks(comm, sum.potential), total_over_ranks(comm, sum.taken)};
}

}  // namespace voussoir
