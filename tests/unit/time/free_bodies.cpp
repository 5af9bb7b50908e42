// Motions of bodies as wholes: taken off exactly, and nothing else.
#include "time/free_bodies.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "linalg/reduce.hpp"
#include "unit/time/floating_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double lower = 2000 * 0.5 * 0.25, upper = lower / 2;  // [kg] of block 0, of blocks 1 and 2
constexpr double round_off = 1e-12;

double largest(const FloatingWall& wall, const std::vector<double>& v) {
  double mine = 0;
  for (int i = 0; i < 2 * wall.mass.owned_nodes(); ++i) mine = std::max(mine, std::abs(v[i]));
  return largest_over_ranks(*wall.mass.comm(), mine);
}

TEUCHOS_UNIT_TEST(FreeBodies, StonesThatNothingTiesLoseAllTheirMotion) {
  const FloatingWall wall;
  const FreeBodies bodies(wall.model, wall.mass, std::vector<char>(wall.model.points().size(), 1));
  auto v = wall.velocity({{1, 2, 0}, {-3, 0, 0}, {0, 5, 0}});
  const auto momentum = bodies.remove_motion(v);
  TEST_FLOATING_EQUALITY(momentum[0], lower * 1 - upper * 3, round_off);
  TEST_FLOATING_EQUALITY(momentum[1], lower * 2 + upper * 5, round_off);
  TEST_COMPARE(largest(wall, v), <, round_off);
  v = wall.velocity({{1, 0, 3}, {0, 1, -2}, {1, 1, 4}});  // turning as well
  bodies.remove_motion(v);
  TEST_COMPARE(largest(wall, v), <, round_off);
}

// Tied they are one body: of (1, 0) of the lower half and (-3, 0) of the upper it keeps what is not its mean, half of
// the mass each, and not a turn about its mass centre either.
TEUCHOS_UNIT_TEST(FreeBodies, TiedStonesLoseTheMotionOfTheirMassCentreAlone) {
  const FloatingWall wall;
  const FreeBodies bodies(wall.model, wall.mass, std::vector<char>(wall.model.points().size(), 0));
  auto v = wall.velocity({{2, 7, 0.5}, {2, 7, 0.5}, {2, 7, 0.5}});
  bodies.remove_motion(v);
  TEST_COMPARE(largest(wall, v), <, 10 * round_off);
  v = wall.velocity({{0, 0, 0}, {0, -1, 0}, {0, 1, 0}});  // the half stones rock: a mean of none, and some turn
  const auto momentum = bodies.remove_motion(v);
  TEST_COMPARE(std::abs(momentum[1]), <, lower * round_off);
  double left[3] = {0, 0, 0};  // momentum and moment of momentum about the origin
  for (int n = 0; n < wall.mass.owned_nodes(); ++n) {
    const auto& x = wall.model.structure().position()[n];
    left[0] += wall.mass_of_node[n] * v[2 * n];
    left[1] += wall.mass_of_node[n] * v[2 * n + 1];
    left[2] += wall.mass_of_node[n] * (x[0] * v[2 * n + 1] - x[1] * v[2 * n]);
  }
  for (double& l : left) TEST_COMPARE(std::abs(total_over_ranks(*wall.mass.comm(), l)), <, lower * round_off);
  TEST_COMPARE(largest(wall, v), >, 0.1);
}

TEUCHOS_UNIT_TEST(FreeBodies, WhatASupportHoldsKeepsItsMotionWithAllThatIsTiedToIt) {
  const FloatingWall wall(true);
  std::vector<char> selected(wall.model.points().size(), 0);
  for (std::size_t k = 0; k < selected.size(); ++k)
    selected[k] = joint_of(wall.model, static_cast<int>(k)).block_j == 2;
  const FreeBodies bodies(wall.model, wall.mass, selected);  // 1 is tied to 0, 2 is free
  const auto before = wall.velocity({{0, 1, 0}, {4, 0, 0}, {0, 3, 0}});
  auto v = before;
  const auto momentum = bodies.remove_motion(v);
  TEST_FLOATING_EQUALITY(momentum[1], upper * 3, round_off);
  const auto& s = wall.model.structure();
  for (int i = 0; i < 2 * s.owned_nodes(); ++i) {
    const bool is_free = s.blocks()[s.block_of_node()[i / 2]].mesh.id == 2;
    TEST_COMPARE(std::abs(v[i] - (is_free ? 0.0 : before[i])), <, round_off);
  }
}

}  // namespace
