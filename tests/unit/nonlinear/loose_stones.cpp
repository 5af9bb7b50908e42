// A stone on two feet, one upon each of two stones that have parted below it: it slides on both.
#include "nonlinear/loose_stones.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <limits>

#include "linalg/local_view.hpp"
#include "nonlinear/active_set.hpp"
#include "nonlinear/patch.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.5;                     // [-]
constexpr double heavy = 60, light = 40;             // [N]
constexpr double back_left = 1.0, back_right = 2.0;  // [m]
constexpr double rigid = 1e9;                        // [N/m]

PatchPoint foot(int first_unknown, double weight_on_it, double slip) {
  auto p = on_the_ground(friction);
  p.unknown = {-1, -1, first_unknown, first_unknown + 1};
  p.gap = {0, slip};
  p.force = {weight_on_it, (slip < 0 ? 1 : -1) * friction * weight_on_it};
  return p;
}

/// Joins the feet of a stone whose first unknown this is.
void add_stone(PatchParts& parts, int first) {
  parts.component.insert(parts.component.end(), {0, 1, 0, 1});
  parts.imbalance.insert(parts.imbalance.end(), {0, heavy, 0, light});
  for (int i = 0; i < 4; ++i) parts.stiffness.push_back({first, first + i, 0});
  for (int i : {first, first + 2})
    for (int j : {first, first + 2}) parts.stiffness.push_back({i, j, i == j ? rigid : -rigid});
}

PatchParts stone_on_two() {
  PatchParts parts;
  add_stone(parts, 0);
  parts.start.assign(4, 0.0);
  parts.proximal_weight.assign(4, 1e-6);
  parts.force_scale = heavy;
  parts.length_scale = 10;
  parts.points = {foot(0, heavy, -back_left), foot(2, light, back_right)};
  return parts;
}

/// Both points slide; forces of friction are at their bounds.
const std::vector<PointStiffness> closed(4, {stone, 0, friction * stone});
const std::vector<double> both_ways = {1, -1, 1, -1};
const std::vector<double> push_left = {friction * (heavy - light), 0, 0, 0};

// Its heavier foot drags it back to where that stone left it, far beyond where forces are in sight.
TEUCHOS_UNIT_TEST(LooseStones, RestWhereTheHeavierFootHoldsThem) {
  Patch patch(stone_on_two());
  NewtonReport report;
  TEST_ASSERT(patch.solve(1e-9, report));
  TEST_FLOATING_EQUALITY(patch.displacement()[0], -back_left, 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_points()[0].force[1], friction * light, 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_points()[1].force[1], -friction * light, 1e-6);
  // As slowly as what slides is let go in one solve it would take hundreds.
  TEST_COMPARE(report.newton_iterations, <=, 6);
}

// From far away active sets go to and fro. Cut short, they give back where it was nearest to rest.
TEUCHOS_UNIT_TEST(LooseStones, AreLeftWhereTheyWereNearestToRest) {
  for (int most = 1; most <= 8; ++most) {
    auto parts = stone_on_two();
    parts.start = {0.3, 0.1, 0.3, 0.1};
    Patch patch(parts);
    ActiveSet active(patch, ActiveSetUse::in_patch, {}, ActiveSetParameters().patience);
    double least = std::numeric_limits<double>::infinity();
    active.narrate = [&](const NewtonProgress& p) { least = std::min(least, std::max(p.residual, p.complementarity)); };
    TpetraVector x(patch.map());
    std::copy(parts.start.begin(), parts.start.end(), local_view_to_write(x));
    PointField lambda;
    for (const auto& p : patch.solved_points()) lambda.insert(lambda.end(), p.force.begin(), p.force.end());
    NewtonReport report;
    TEST_ASSERT(active.solve(x, lambda, -1, most, nullptr, report) == ActiveSetEnd::circled);
    out << most << " solves: " << report.residual << " + " << report.complementarity << ", " << least / heavy << "\n";
    TEST_COMPARE(std::max(report.residual, report.complementarity), <=, 1.001 * least / heavy);
  }
}

TEUCHOS_UNIT_TEST(LooseStones, StopAtTheFirstPointThatIsBack) {
  const auto parts = stone_on_two();
  std::vector<double> moved(4, 0.0);
  const auto stops = LooseStones(parts).move_on(parts.points, {closed, both_ways, {{0, -back_left}, {0, back_right}}},
                                                push_left.data(), 1e-9, moved.data());
  TEST_COMPARE_ARRAYS(stops, std::vector<int>{0});
  TEST_COMPARE_ARRAYS(moved, (std::vector<double>{-back_left, 0, -back_left, 0}));
}

TEUCHOS_UNIT_TEST(LooseStones, StayWhereTheyAreInBalanceOrHeld) {
  auto parts = stone_on_two();
  const PointStatuses statuses{closed, both_ways, {{0, -back_left}, {0, back_right}}};
  std::vector<double> moved(4, 0.0);
  TEST_ASSERT(LooseStones(parts).move_on(parts.points, statuses, push_left.data(), 11, moved.data()).empty());
  const std::vector<PointStiffness> one_sticks = {{stone, stone, 0}, closed[1]};
  TEST_ASSERT(LooseStones(parts)
                  .move_on(parts.points, {one_sticks, {0, -1}, statuses.motion}, push_left.data(), 1e-9, moved.data())
                  .empty());
  parts.stiffness.push_back({0, 0, spring});
  TEST_ASSERT(LooseStones(parts).move_on(parts.points, statuses, push_left.data(), 1e-9, moved.data()).empty());
  TEST_COMPARE_ARRAYS(moved, std::vector<double>(4, 0.0));
}

TEUCHOS_UNIT_TEST(LooseStones, StayWhereBedsAreNotParallel) {
  auto parts = stone_on_two();
  parts.points[1].axis = {{{0.6, 0.8}, {-0.8, 0.6}}};
  std::vector<double> moved(4, 0.0);
  TEST_ASSERT(LooseStones(parts)
                  .move_on(parts.points, {closed, both_ways, {{0, -back_left}, {0, back_right}}}, push_left.data(),
                           1e-9, moved.data())
                  .empty());
}

// The first comes to a stop at the second, half a metre on; the second, which nothing holds either, goes with it to
// where its own foot is back on the ground.
TEUCHOS_UNIT_TEST(LooseStones, TakeEachOtherAlong) {
  auto parts = stone_on_two();
  add_stone(parts, 4);
  constexpr double near = 0.5;
  auto between = foot(0, heavy, -near);
  between.unknown = {4, 5, 0, 1};
  parts.points = {between, foot(2, light, back_right), foot(4, heavy, -back_left), foot(6, light, back_right)};
  const std::vector<double> push = {push_left[0], 0, 0, 0, 0, 0, 0, 0};
  std::vector<double> moved(8, 0.0);
  const auto stops = LooseStones(parts).move_on(
      parts.points, {closed, both_ways, {{0, -near}, {0, back_right}, {0, -back_left}, {0, back_right}}}, push.data(),
      1e-9, moved.data());
  TEST_COMPARE_ARRAYS(stops, (std::vector<int>{0, 2}));
  for (int i : {0, 2}) TEST_FLOATING_EQUALITY(moved[i], -near - back_left, 1e-12);
  for (int i : {4, 6}) TEST_FLOATING_EQUALITY(moved[i], -back_left, 1e-12);
}

}  // namespace
