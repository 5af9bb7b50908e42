// Facets cut by joints: stones have the same cells where they touch, and stay closed.
#include "stones/imprint.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

Imprint cut(const std::vector<StoneSurface>& stones, double tolerance, double weld) {
  const auto faceted = facets_of(stones, tolerance);
  return imprinted(faceted, find_joints(faceted, tolerance), weld);
}

double shared_area(const Imprint& imprint) {
  double sum = 0;
  for (std::size_t c = 0; c < imprint.cells.size(); ++c)
    if (imprint.other[c] >= 0) sum += imprint.cells[c].area / 2;
  return sum;
}

int shared_cells(const Imprint& imprint) {
  return static_cast<int>(std::count_if(imprint.other.begin(), imprint.other.end(), [](int c) { return c >= 0; })) / 2;
}

TEUCHOS_UNIT_TEST(Imprint, BricksOfABondHaveAFaceForEachNeighbour) {
  const auto imprint = cut(running_bond(), 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 5);
  TEST_FLOATING_EQUALITY(shared_area(imprint), 0.2, 1e-12);
  // 4 boxes of 6 faces; the tops of a and b and the bottom of c are halves.
  TEST_EQUALITY(imprint.cells.size(), 27u);
  // 3, 5 and 3 places along the wall at the heights 0, 0.2 and 0.4, on either face.
  TEST_EQUALITY(imprint.points.size(), 22u);
  TEST_FLOATING_EQUALITY(imprint.shortest_edge, 0.2, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, PointsInsideFacetsAreNone) {
  auto stones = running_bond();
  const auto drawn = cut(stones, 1e-3, 3e-3);
  // The top of the first stone as four triangles about a point a millimetre beside the head joint of those above.
  const auto top = stones[0].faces.back();
  stones[0].faces.pop_back();
  stones[0].points.push_back({0.201, 0.1, 0.2});
  for (std::size_t k = 0; k < 4; ++k) stones[0].faces.push_back({top[k], top[(k + 1) % 4], 8});
  const auto triangles = cut(stones, 1e-3, 3e-3);
  TEST_ASSERT(triangles.faults.none());
  TEST_EQUALITY(triangles.points.size(), drawn.points.size());
  TEST_EQUALITY(triangles.cells.size(), drawn.cells.size());
}

TEUCHOS_UNIT_TEST(Imprint, AFaceAroundASmallerStoneHasAHole) {
  const auto imprint = cut({box("slab", {0, 0, 0}, {3, 3, 1}), box("post", {1, 1, 1}, {2, 2, 2})}, 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 1);
  const auto ring =
      std::find_if(imprint.cells.begin(), imprint.cells.end(), [](const auto& c) { return !c.holes.empty(); });
  TEST_ASSERT(ring != imprint.cells.end());
  TEST_FLOATING_EQUALITY(ring->area, 8.0, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, StonesThatAreNotConvexAreCutByTheWholeJoint) {
  const auto imprint = cut(corner(), 1e-3, 3e-3);
  TEST_ASSERT(imprint.faults.none());
  TEST_EQUALITY(shared_cells(imprint), 4);
  TEST_FLOATING_EQUALITY(shared_area(imprint), 6.0, 1e-12);
}

TEUCHOS_UNIT_TEST(Imprint, HoldsTurnedMovedInOtherUnitsAndMeasured) {
  const std::vector<std::vector<StoneSurface>> cases{arch(9), corner(), running_bond()};
  for (const auto& stones : cases) {
    const auto here = cut(stones, 1e-3, 3e-3);
    for (const double scale : {1.0, 1e3, 1e-3}) {
      const auto there = cut(turned(stones, scale, scale * Vector<3>{20, -10, 3}), 1e-3 * scale, 3e-3 * scale);
      TEST_ASSERT(there.faults.none());
      TEST_EQUALITY(there.cells.size(), here.cells.size());
      TEST_FLOATING_EQUALITY(shared_area(there), scale * scale * shared_area(here), 1e-10);
    }
    for (const double noise : {1e-4, 5e-4, 2e-3}) {
      const auto as_measured = cut(measured(stones, noise), 4 * noise, 12 * noise);
      TEST_ASSERT(as_measured.faults.none());
      TEST_EQUALITY(shared_cells(as_measured), shared_cells(here));
      TEST_FLOATING_EQUALITY(shared_area(as_measured), shared_area(here), 20 * noise);
    }
  }
}

TEUCHOS_UNIT_TEST(Imprint, AWeldBelowTheGapIsRefusedWithWhatToDo) {
  // The joint is found, but the corners of its two sides are 1 mm apart and stay apart.
  std::vector<StoneSurface> stones{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.001, 0, 0}, {2, 1, 1})};
  const auto faceted = facets_of(stones, 2e-3);
  const auto imprint = imprinted(faceted, find_joints(faceted, 2e-3), 1e-4);
  TEST_ASSERT(!imprint.faults.none());
  const auto error = input_error([&] { refuse_faults(imprint, faceted, 2e-3, 1e-4); });
  TEST_ASSERT(holds(error, "joint tolerance = 0.002 [m] and weld = 1e-4 [m]"));
  TEST_ASSERT(holds(error, "stone \"a\""));
  const auto welded = imprinted(faceted, find_joints(faceted, 2e-3), 4e-3);
  TEST_ASSERT(welded.faults.none());
  TEST_EQUALITY(shared_cells(welded), 1);
}

}  // namespace
