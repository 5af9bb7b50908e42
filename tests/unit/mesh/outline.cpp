// How deep outlines lie in each other, against what a ruler says.
#include <Teuchos_UnitTestHarness.hpp>

#include "mesh/outline.hpp"

namespace {

using namespace voussoir;

/// Edges of a polygon, each in equal parts.
Outline polygon(const std::vector<Vector<2>>& corners, int parts = 1) {
  Outline outline;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto from = corners[k], side = corners[(k + 1) % corners.size()] - from;
    for (int p = 0; p < parts; ++p)
      outline.push_back({from + (double(p) / parts) * side, from + (double(p + 1) / parts) * side});
  }
  return outline;
}

Outline rectangle(double x0, double y0, double x1, double y1, int parts = 1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, parts);
}

constexpr double tolerance = 1e-3, round_off = 1e-12;

TEUCHOS_UNIT_TEST(Outline, TheBorderOfCellsHasTheBlockOnItsLeft) {
  const std::vector<Cell> cells{{{0, 1, 4, 3}, 4}, {{1, 2, 5, 4}, 4}};  // two squares side by side
  const auto border = border_of(cells);
  TEST_EQUALITY(border.size(), 6u);
  for (const auto& side : border) TEST_ASSERT(!(side[0] == 1 && side[1] == 4) && !(side[0] == 4 && side[1] == 1));
  const std::vector<Vector<2>> place{{0, 0}, {1, 0}, {3, 0}, {0, 0.5}, {1, 0.5}, {3, 0.5}};
  TEST_EQUALITY(shortest_side(cells, place.data()), 0.5);
}

TEUCHOS_UNIT_TEST(Outline, PlacesAreWithinOrWithoutHolesIncluded) {
  auto ring = rectangle(0, 0, 3, 3);
  const auto hole = polygon({{1, 1}, {1, 2}, {2, 2}, {2, 1}});  // the block to its left: clockwise
  ring.insert(ring.end(), hole.begin(), hole.end());
  TEST_ASSERT(inside(ring, {0.5, 0.5}));
  TEST_ASSERT(!inside(ring, {1.5, 1.5}));
  TEST_ASSERT(!inside(ring, {3.5, 1.5}));
  TEST_FLOATING_EQUALITY(distance_to_border(ring, {1.5, 1.25}), 0.25, round_off);
  TEST_FLOATING_EQUALITY(distance_to_border(ring, {4, 4}), std::sqrt(2.0), round_off);
}

TEUCHOS_UNIT_TEST(Outline, StonesThatTouchOrSlideAlongEachOtherDoNotOverlap) {
  const auto low = rectangle(0, 0, 1, 1, 4);
  TEST_EQUALITY(overlap_depth(low, rectangle(0, 1, 1, 2, 4), tolerance), 0.0);
  TEST_EQUALITY(overlap_depth(low, rectangle(0.3, 1, 1.3, 2, 4), tolerance), 0.0);
  TEST_EQUALITY(overlap_depth(low, rectangle(1, 1, 2, 2), tolerance), 0.0);  // corner on corner
  TEST_EQUALITY(overlap_depth(low, rectangle(0, 0.9995, 1, 2, 4), tolerance), 0.0);
  TEST_EQUALITY(overlap_depth(low, rectangle(5, 5, 6, 6), tolerance), 0.0);
}

TEUCHOS_UNIT_TEST(Outline, TheDepthIsHowFarOneHasToBeDrawnBackInAnyOrder) {
  const auto stone = rectangle(0, 0, 1, 1);
  for (const int parts : {1, 3}) {  // faces of equal height: only middles of edges lie within
    const auto other = rectangle(0.9, 0, 1.9, 1, parts);
    TEST_FLOATING_EQUALITY(overlap_depth(stone, other, tolerance), 0.1, round_off);
    TEST_FLOATING_EQUALITY(overlap_depth(other, stone, tolerance), 0.1, round_off);
  }
  // A corner pushed 0.25 into a face: an edge that stands on its corner.
  const double r = 0.5;
  const auto diamond = polygon({{1.25, -r}, {1.25 + r, 0}, {1.25, r}, {1.25 - r, 0}});
  const auto wide = rectangle(0, -3, 1, 3, 7);
  TEST_FLOATING_EQUALITY(overlap_depth(wide, diamond, tolerance), 0.25, round_off);
}

TEUCHOS_UNIT_TEST(Outline, AStoneInACornerOfAnotherIsDrawnBackTheShortWay) {
  const auto block = polygon({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {0, 1}});  // a foot and an upright
  TEST_EQUALITY(overlap_depth(block, rectangle(1, 1, 2, 1.5, 2), tolerance), 0.0);
  TEST_FLOATING_EQUALITY(overlap_depth(block, rectangle(1.2, 1, 2.2, 1.5, 2), tolerance), 0.2, round_off);
}

TEUCHOS_UNIT_TEST(Outline, AFaceGoesOnAlongStonesThatLieFlushWithIt) {
  const double cell = 0.25;
  const Outline top{{{1, 1}, {0, 1}}};  // of a stone of 1 m
  const auto length = [&](const Outline& face, const Outline& others) {
    double sum = 0;
    for (const auto& [from, to] : with_what_goes_on_flush(face, others, cell)) sum += norm(to - from);
    return sum;
  };
  const auto turned = [](Outline outline, double x0) {  // by 30 degrees, about the origin, and away
    const double c = std::sqrt(0.75), s = 0.5;
    for (auto& edge : outline)
      for (auto* x : {&edge.from, &edge.to}) *x = {x0 + c * (*x)[0] - s * (*x)[1], s * (*x)[0] + c * (*x)[1]};
    return outline;
  };
  auto row = rectangle(1, 0, 2, 1, 4);  // two to the right, one to the left, not in their order
  for (const auto& more : {rectangle(-2, 0, 0, 1), rectangle(2, 0, 3, 1, 3)})
    row.insert(row.begin(), more.begin(), more.end());
  TEST_FLOATING_EQUALITY(length(top, row), 5.0, round_off);
  TEST_FLOATING_EQUALITY(length(turned(top, 1e3), turned(row, 1e3)), 5.0, 1e-10);
  TEST_FLOATING_EQUALITY(length(top, rectangle(1.1, 0, 2, 1)), 1.9, round_off);    // a gap a point stands across
  TEST_FLOATING_EQUALITY(length(top, rectangle(1, 0, 2, 0.998)), 2.0, round_off);  // a step as two stones may have
  TEST_FLOATING_EQUALITY(length(top, rectangle(1.2, 0, 2, 1)), 1.0, round_off);    // a gap
  TEST_FLOATING_EQUALITY(length(top, rectangle(1, 0, 2, 0.98)), 1.0, round_off);   // a step down
  TEST_FLOATING_EQUALITY(length(top, rectangle(1, 0, 2, 1.02)), 1.0, round_off);   // and up
  TEST_FLOATING_EQUALITY(length(top, rectangle(1, 1, 2, 2)), 1.0, round_off);      // a face that looks the other way
  TEST_FLOATING_EQUALITY(length(top, polygon({{1, 0}, {2, 0}, {2, 0.9}, {1, 1}})), 1.0, round_off);  // a slope
  TEST_FLOATING_EQUALITY(length(top, rectangle(2, 0, 3, 1)), 1.0, round_off);  // with nothing between
}

}  // namespace
