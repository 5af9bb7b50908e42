// Facets and joints of drawn stones, wherever they stand, however large they are, and as they are measured.
#include <Teuchos_UnitTestHarness.hpp>

#include "stones/polygon.hpp"
#include "stones/stone_joints.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

StoneJoints joints(const std::vector<StoneSurface>& stones, double tolerance) {
  const auto mended = closed(stones).stones;
  return find_joints(facets_of(mended, tolerance), tolerance);
}

/// Every face in triangles.
std::vector<StoneSurface> in_triangles(std::vector<StoneSurface> stones) {
  for (auto& stone : stones) {
    std::vector<std::vector<int>> faces;
    for (const auto& face : stone.faces)
      for (const auto& t : cut_into_triangles(places_of(stone.points, face)))
        faces.push_back({face[t[0]], face[t[1]], face[t[2]]});
    stone.faces = faces;
  }
  return stones;
}

TEUCHOS_UNIT_TEST(Facets, TrianglesInAPlaneAreOneFacet) {
  const auto stones = in_triangles(corner());
  TEST_EQUALITY(facets_of(stones[0], 1e-3).facets.size(), 8u);
  TEST_EQUALITY(facets_of(stones[1], 1e-3).facets.size(), 6u);
  const auto arches = in_triangles(arch(5));
  for (const auto& stone : facets_of(arches, 1e-3)) TEST_EQUALITY(stone.facets.size(), 6u);
}

TEUCHOS_UNIT_TEST(Facets, AFaceOutOfPlaneIsTwoTriangles) {
  StoneSurface stone = box("warped", {0, 0, 0}, {1, 1, 1});
  stone.points.back()[2] = 1.02;
  const auto fine = facets_of(stone, 1e-3), coarse = facets_of(stone, 0.1);
  TEST_EQUALITY(fine.warped, 1);
  TEST_FLOATING_EQUALITY(fine.farthest, 0.005, 1e-2);  // a quarter of the corner's height, to its slope
  TEST_EQUALITY(fine.facets.size(), 7u);
  TEST_EQUALITY(coarse.facets.size(), 6u);
}

TEUCHOS_UNIT_TEST(Joints, OffsetBoxesShareWhatOverlaps) {
  const auto found = joints(running_bond(), 1e-3);
  TEST_EQUALITY(found.joints.size(), 5u);
  // a - b, c - d: 0.04 each; c on a and b: 0.04 each; d on b: 0.04.
  for (const auto& joint : found.joints) TEST_FLOATING_EQUALITY(joint.area, 0.04, 1e-12);
  const auto& bed = found.joints[1];
  TEST_ASSERT(bed.stone == (std::array<int, 2>{0, 2}));
  TEST_COMPARE(norm(bed.normal - Vector<3>{0, 0, 1}), <=, 1e-14);
  TEST_COMPARE(bed.farthest, <=, 1e-14);
}

TEUCHOS_UNIT_TEST(Joints, AStoneThatIsNotConvexHasTheJointsOfItsFacets) {
  const auto found = joints(in_triangles(corner()), 1e-3);
  TEST_EQUALITY(found.joints.size(), 4u);
  TEST_FLOATING_EQUALITY(found.area(), 2 * 1.0 + 3.0 + 1.0, 1e-12);
}

TEUCHOS_UNIT_TEST(Joints, AreTheSameTurnedMovedAndInOtherUnits) {
  const std::vector<std::vector<StoneSurface>> cases{arch(7), corner(), running_bond()};
  for (const auto& stones : cases) {
    const auto here = joints(stones, 1e-3);
    for (const double scale : {1.0, 1e3, 1e-3}) {
      const auto there = joints(turned(stones, scale, scale * Vector<3>{20, -10, 3}), 1e-3 * scale);
      TEST_EQUALITY(there.joints.size(), here.joints.size());
      TEST_FLOATING_EQUALITY(there.area(), scale * scale * here.area(), 1e-10);
    }
  }
}

TEUCHOS_UNIT_TEST(Joints, StayTheSameWhenStonesAreMeasuredToHalfTheirTolerance) {
  // A quarter of the tolerance in each direction: planes of two stones at a corner are less than the tolerance apart.
  const std::vector<std::vector<StoneSurface>> cases{arch(7), corner()};
  for (const auto& stones : cases)
    for (const double noise : {1e-4, 5e-4, 2e-3}) {
      const auto drawn = joints(stones, 4 * noise), found = joints(measured(stones, noise), 4 * noise);
      TEST_EQUALITY(found.joints.size(), drawn.joints.size());
      TEST_FLOATING_EQUALITY(found.area(), drawn.area(), 20 * noise);  // m2 of facets of 1 m, moved by the noise
    }
}

TEUCHOS_UNIT_TEST(Joints, AreTheSameOfStonesThatWentThroughStl) {
  const std::vector<std::vector<StoneSurface>> cases{arch(7), corner(), running_bond()};
  for (const auto& stones : cases) {
    const auto drawn = turned(stones, 1, {20, -10, 3});
    const auto read = through_stl(drawn);
    for (std::size_t k = 0; k < read.size(); ++k) {
      TEST_EQUALITY(read[k].points.size(), drawn[k].points.size());
      TEST_EQUALITY(facets_of(read[k], 1e-3).facets.size(), facets_of(drawn[k], 1e-3).facets.size());
    }
    const auto before = joints(drawn, 1e-3), after = joints(read, 1e-3);
    TEST_EQUALITY(after.joints.size(), before.joints.size());
    TEST_FLOATING_EQUALITY(after.area(), before.area(), 1e-5);  // float32 of 20 m is 1e-6 m
  }
}

TEUCHOS_UNIT_TEST(Joints, OpenOnesAppearWhenTheToleranceReachesTheGap) {
  auto stones = std::vector<StoneSurface>{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.01, 0, 0}, {2, 1, 1})};
  TEST_EQUALITY(joints(stones, 5e-3).joints.size(), 0u);
  const auto found = joints(stones, 2e-2);
  TEST_EQUALITY(found.joints.size(), 1u);
  TEST_FLOATING_EQUALITY(found.joints[0].opening, 0.01, 1e-10);
  for (auto& x : stones[1].points) x[0] -= 0.015;
  TEST_FLOATING_EQUALITY(joints(stones, 2e-2).joints[0].opening, -0.005, 1e-10);
}

TEUCHOS_UNIT_TEST(Joints, NarrowStripsAreSlivers) {
  const auto found = joints({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0, 0.9995, 1}, {1, 2, 2})}, 1e-3);
  TEST_EQUALITY(found.joints.size(), 0u);
  TEST_EQUALITY(found.slivers, 1);
  TEST_FLOATING_EQUALITY(found.sliver_area, 5e-4, 1e-9);
}

TEUCHOS_UNIT_TEST(Joints, TheirNumberHasAPlateauWhereTheDrawingHasOne) {
  // Stones measured to 0.5 mm: joints are lost below the noise, and stay the same above it.
  const auto stones = measured(arch(7), 5e-4);
  const auto counts = count_joints(stones, 2e-3);
  TEST_ASSERT(counts.front().joints < 6 || counts.front().area < 3);
  const double proposed = tolerance_on_plateau(counts);
  TEST_COMPARE(proposed, >=, 1e-3);
  TEST_EQUALITY(joints(stones, proposed).joints.size(), 6u);
  TEST_EQUALITY(tolerance_on_plateau(count_joints({stones[0]}, 1e-3)), 0.0);
}

}  // namespace
