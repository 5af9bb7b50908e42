// Cells of drawn stones: nodes match, quadrilaterals where stones are, areas and sets.
#include "drawings/plane_mesh.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <set>

#include "mesh/border.hpp"
#include "mesh/mesh_check.hpp"
#include "unit/drawings/drawn_walls.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

PlaneMeshes meshed_stones(std::vector<OutlinedStone> stones, double snap, double element,
                          StoneCells cells = StoneCells::by_shape) {
  return mesh_plane_stones(plane_stones_of(file_of(std::move(stones)), asked(snap, element)), cells);
}

double area_of(const Block<2>& block) {
  double sum = 0;
  for (const auto& cell : block.cells)
    for (int k = 1; k + 1 < cell.count; ++k)
      sum += cross(block.position[cell.node[k]] - block.position[cell.node[0]],
                   block.position[cell.node[k + 1]] - block.position[cell.node[0]]) /
             2;
  return sum;
}

/// Edges of the border by their vertices, and how many blocks have each.
std::map<std::array<VertexId, 2>, int> border_uses(const BlockList<2>& list) {
  std::map<std::array<VertexId, 2>, int> uses;
  for (const auto& edge : border_facets(list.blocks)) ++uses[edge.vertices];
  return uses;
}

int facets_in(const Block<2>& block, int set) {
  return static_cast<int>(
      std::count_if(block.facets.begin(), block.facets.end(), [&](const TaggedFacet& f) { return f.set == set; }));
}

TEUCHOS_UNIT_TEST(PlaneMesh, AWallIsOfTheCellsThatItsSizeAsksFor) {
  const auto meshes = meshed_stones(bond(3, 3, 0.4, 0.2), 1e-3, 0.1);
  TEST_EQUALITY(meshes.of_quadrilaterals, 10);
  for (const auto& block : meshes.list.blocks) {
    const bool half = std::abs(area_of(block) - 0.04) < 1e-12;
    TEST_EQUALITY(block.cells.size(), half ? 4u : 8u);
    TEST_EQUALITY(block.position.size(), half ? 9u : 15u);
    TEST_FLOATING_EQUALITY(area_of(block), half ? 0.04 : 0.08, 1e-12);
  }
  int joints = 0;
  for (const auto& [edge, uses] : border_uses(meshes.list)) joints += uses == 2;
  TEST_EQUALITY(joints, 7 * 2 + 2 * 12);
  TEST_EQUALITY(meshes.list.blocks[0].name, "stone 0.0 at (0.2, 0.1)");
}

TEUCHOS_UNIT_TEST(PlaneMesh, EveryNodeOfAJointIsThereOnBothSidesInASurveyToo) {
  for (const auto cells : {StoneCells::by_shape, StoneCells::triangles}) {
    const auto meshes = meshed_stones(bond(5, 4, 0.6, 0.3, 5e-3), 0, 0.1, cells);
    const auto s = plane_stones_of(file_of(bond(5, 4, 0.6, 0.3, 5e-3)), asked(0, 0.1));
    double joint_length = 0;
    const auto uses = border_uses(meshes.list);
    for (const auto& edge : border_facets(meshes.list.blocks))
      if (uses.at(edge.vertices) == 2)
        joint_length += norm(meshes.list.blocks[edge.block].position[edge.node[1]] -
                             meshes.list.blocks[edge.block].position[edge.node[0]]) /
                        2;
    TEST_FLOATING_EQUALITY(joint_length, s.snapped.joint_length, 1e-12);
    TEST_EQUALITY(meshes.of_quadrilaterals, cells == StoneCells::by_shape ? 22 : 0);
    for (const auto& block : meshes.list.blocks)
      for (const auto& cell : block.cells) TEST_EQUALITY(cell.count, cells == StoneCells::by_shape ? 4 : 3);
  }
}

TEUCHOS_UNIT_TEST(PlaneMesh, OtherShapesAreOfTrianglesAndFillTheStone) {
  const auto meshes =
      meshed_stones({stone("frame", box(0, 0, 3, 3), {box(1, 1, 1, 1)}), stone("heart", box(1, 1, 1, 1)),
                     stone("five", {{0, 3}, {3, 3}, {3, 4}, {1.5, 5}, {0, 4}})},
                    1e-3, 0.5);
  TEST_EQUALITY(meshes.of_quadrilaterals, 1);
  TEST_FLOATING_EQUALITY(area_of(meshes.list.blocks[0]), 8.0, 1e-12);
  TEST_FLOATING_EQUALITY(area_of(meshes.list.blocks[1]), 1.0, 1e-12);
  TEST_FLOATING_EQUALITY(area_of(meshes.list.blocks[2]), 4.5, 1e-12);
}

TEUCHOS_UNIT_TEST(PlaneMesh, SetsAreNamesLayersAndEnds) {
  auto stones = bond(2, 2, 1.0, 0.5);
  stones[0].sets = stones[1].sets = {"lower"};
  const auto list = meshed_stones(stones, 1e-3, 0.5).list;
  TEST_EQUALITY(list.block_sets[0], "lower");
  TEST_ASSERT(list.facet_sets == (std::vector<std::string>{"base", "top", "left", "right", "faces"}));
  TEST_ASSERT(list.blocks[0].sets == (std::vector<int>{0, 1}));
  TEST_EQUALITY(facets_in(list.blocks[0], 0), 2);  // base
  TEST_EQUALITY(facets_in(list.blocks[0], 1), 0);
  TEST_EQUALITY(facets_in(list.blocks[0], 2), 1);  // left
  TEST_EQUALITY(facets_in(list.blocks[0], 3), 0);
  TEST_EQUALITY(facets_in(list.blocks[0], 4), 6);  // all of it
  TEST_EQUALITY(facets_in(list.blocks[3], 1), 2);  // the middle one of the upper course: top
}

TEUCHOS_UNIT_TEST(PlaneMesh, CornersOfTheDrawingAreFoldsAndPointsOfCurvesAreNone) {
  DrawnLoop loop{{{0, 0}, {2, 0}, {2, 1}, {1, 1.02}, {0, 1}}, {0, 0, 0, 1, 0}};
  OutlinedStone low = stone("low", {}), high = stone("high", {{0, 1}, {1, 1.02}, {2, 1}, {2, 2}, {0, 2}});
  low.loops = {loop};
  high.loops[0].curved = {0, 1, 0, 0, 0};
  const auto list = meshed_stones({low, high}, 1e-3, 0.5).list;
  for (const auto& block : list.blocks) {
    TEST_EQUALITY(block.folds.size(), 4u);
    for (const int n : block.folds) TEST_ASSERT(std::abs(block.position[n][0] - 1) > 0.5);
  }
}

TEUCHOS_UNIT_TEST(PlaneMesh, ThePictureShowsStonesBeforeAndAfter) {
  const auto s = plane_stones_of(file_of(bond(2, 2, 1.0, 0.5, 5e-3)), asked());
  const auto svg = picture_of(s);
  TEST_EQUALITY(svg.compare(0, 4, "<svg"), 0);
  TEST_EQUALITY(std::count(svg.begin(), svg.end(), 'Z'), 10);  // five outlines, twice
  TEST_ASSERT(test::holds(svg, "snap "));
}

}  // namespace
