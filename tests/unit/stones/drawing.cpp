// Cells of plane drawings.
#include "stones/drawing.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace {

using namespace voussoir;

/// A square with its points from `first` on.
void add_square(Drawing2& drawing, double x, double y, double side) {
  const int first = static_cast<int>(drawing.points.size());
  for (const auto& p : Polygon{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}) drawing.points.push_back(p);
  for (int k = 0; k < 4; ++k) drawing.edges.push_back({first + k, first + (k + 1) % 4});
}

TEUCHOS_UNIT_TEST(Drawing, ASquareCutOnceIsTwoCells) {
  Drawing2 drawing;
  add_square(drawing, 0, 0, 1);
  drawing.edges.push_back({0, 2});
  const auto cells = cells_of(drawing);
  TEST_EQUALITY(cells.size(), 2u);
  for (const auto& cell : cells) {
    TEST_FLOATING_EQUALITY(cell.area, 0.5, 1e-15);
    TEST_EQUALITY(cell.outer.size(), 3u);
  }
}

TEUCHOS_UNIT_TEST(Drawing, ASquareInsideIsACellAndAHole) {
  Drawing2 drawing;
  add_square(drawing, 0, 0, 4);
  add_square(drawing, 1, 1, 1);
  const auto cells = cells_of(drawing);
  TEST_EQUALITY(cells.size(), 2u);
  const auto& ring = cells[0].holes.empty() ? cells[1] : cells[0];
  TEST_EQUALITY(ring.holes.size(), 1u);
  TEST_FLOATING_EQUALITY(ring.area, 15.0, 1e-14);
  TEST_ASSERT(ring.inside[0] > 2 || ring.inside[1] > 2 || ring.inside[0] < 1 || ring.inside[1] < 1);
  TEST_EQUALITY(winding(drawing.points, drawing.edges, ring.inside), 1);
  TEST_EQUALITY(winding(drawing.points, drawing.edges, {1.5, 1.5}), 2);
  TEST_EQUALITY(winding(drawing.points, drawing.edges, {5, 1}), 0);
}

TEUCHOS_UNIT_TEST(Drawing, EdgesThatHangFreeBoundNothing) {
  Drawing2 drawing;
  add_square(drawing, 0, 0, 1);
  drawing.points.push_back({0.5, 0.5});
  drawing.points.push_back({0.6, 0.5});
  drawing.edges.push_back({0, 4});
  drawing.edges.push_back({4, 5});
  const auto cells = cells_of(drawing);
  TEST_EQUALITY(cells.size(), 1u);
  TEST_EQUALITY(cells[0].outer.size(), 4u);
}

TEUCHOS_UNIT_TEST(Drawing, AHoleThatTouchesTheBorderIsPartOfIt) {
  // A triangle inside with one corner on the border: one loop that comes by that point twice.
  Drawing2 drawing;
  add_square(drawing, 0, 0, 1);
  drawing.points.push_back({0.5, 0.2});
  drawing.points.push_back({0.2, 0.5});
  for (const auto& e : std::vector<std::array<int, 2>>{{0, 4}, {4, 5}, {5, 0}}) drawing.edges.push_back(e);
  const auto cells = cells_of(drawing);
  TEST_EQUALITY(cells.size(), 2u);
  double sum = 0;
  for (const auto& cell : cells) sum += cell.area;
  TEST_FLOATING_EQUALITY(sum, 1.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Drawing, CrossingsAreFound) {
  Drawing2 drawing;
  add_square(drawing, 0, 0, 1);
  TEST_ASSERT(crossings_of(drawing).empty());
  drawing.edges.push_back({0, 2});
  drawing.edges.push_back({1, 3});
  TEST_ASSERT(crossings_of(drawing) == (std::vector<std::array<int, 2>>{{4, 5}}));
}

}  // namespace
