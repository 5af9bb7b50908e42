#include "nonlinear/creeping_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// So often a change of a sticking point's forces can be repeated until it slips: |q + t dq| = bound + t times its
/// change.
double repeats_to_slip(const PointLaw& law, const double* force, const double* change, int components) {
  const double bound = friction_bound(law, force[0]);
  if (!std::isfinite(bound)) return unbounded;
  const double wider = (std::isfinite(law.friction) ? law.friction : 0.0) * change[0];
  double square = -wider * wider, mixed = -bound * wider, room = bound * bound;
  for (int c = 1; c < components; ++c) {
    square += change[c] * change[c];
    mixed += change[c] * force[c];
    room -= force[c] * force[c];
  }
  room = std::max(0.0, room);
  const double root = mixed * mixed + square * room;
  if (root < 0 || mixed + std::sqrt(root) <= 0) return unbounded;
  return room / (mixed + std::sqrt(root));
}

/// Until a point comes to its bound: a closed one opens, a sticking one slips; the friction of a sliding one follows.
double repeats(const PointLaw& law, bool slides, const double* force, const double* change, int components) {
  double most = unbounded;
  if (change[0] < 0 && std::isfinite(law.tension)) most = std::max(0.0, force[0] + law.tension) / -change[0];
  return slides ? most : std::min(most, repeats_to_slip(law, force, change, components));
}

/// Largest part of a change that goes round [N]; 0 of another. Collective.
double size_of_creeping(NonlinearProblem& problem, const Creep& creep, double alike) {
  std::array<double, 2> mine{};
  for (std::size_t i = 0; i < creep.change_before.size(); ++i) {
    mine[0] = std::max(mine[0], std::abs(creep.change[i]));
    mine[1] = std::max(mine[1], std::abs(creep.change[i] - creep.change_before[i]));
  }
  const auto all = largest_of_each(*problem.map()->getComm(), mine);
  if (!(all[0] > 0 && all[1] <= alike * all[0])) return 0;
  TpetraVector at_nodes(problem.map());
  problem.subtract_contact_forces(creep.change, at_nodes);
  return at_nodes.normInf() <= alike * all[0] ? all[0] : 0;
}

}  // namespace

bool go_to_the_bound(NonlinearProblem& problem, const CurrentLaws& laws, const Creep& creep, double alike,
                     PointField& lambda) {
  const double least = alike * size_of_creeping(problem, creep, alike);
  if (!(least > 0)) return false;
  const int n = problem.components();
  double mine = unbounded;
  for (int k = 0; k < problem.owned_points(); ++k) {
    if (!problem.selected()[k] || !creep.closed[k]) continue;
    const auto* const change = &creep.change[std::size_t(k) * n];
    if (std::none_of(change, change + n, [&](double c) { return std::abs(c) > least; })) continue;
    const auto* const s = &creep.sliding[std::size_t(k) * (n - 1)];
    const bool slides = std::any_of(s, s + n - 1, [](double c) { return c != 0; });
    mine = std::min(mine, repeats(laws[k], slides, &lambda[std::size_t(k) * n], change, n));
  }
  const double all = least_over_ranks(*problem.map()->getComm(), mine);
  if (!std::isfinite(all)) return false;
  // Once more, as a solve would, so that round-off of the change leaves no point short of its bound.
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] += (all + 1) * creep.change[i];
  return true;
}

}  // namespace voussoir
