// Hexahedra in stones that are boxes.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <map>

#include "stones/box_mesh.hpp"
#include "stones/box_shape.hpp"
#include "stones/filled_stones.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// [m2] of faces that two blocks have, by the vertices of their cells' faces.
double area_shared(const std::vector<Block<3>>& blocks) {
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  std::map<std::array<VertexId, 4>, std::map<BlockId, double>> uses;
  for (const auto& block : blocks)
    for (const auto& cell : block.cells)
      for (const auto& face : faces) {
        std::array<VertexId, 4> key;
        Places x;
        for (int k = 0; k < 4; ++k) {
          key[k] = block.vertex[cell.node[face[k]]];
          x.push_back(block.position[cell.node[face[k]]]);
        }
        std::sort(key.begin(), key.end());
        uses[key][block.id] = norm(area_vector(x));
      }
  double sum = 0;
  for (const auto& [key, of] : uses)
    if (of.size() == 2) sum += of.begin()->second;
  return sum;
}

TEUCHOS_UNIT_TEST(Boxes, APlaceAndWhereItLiesBelongTogether) {
  BoxShape shape;
  for (std::size_t c = 0; c < 8; ++c)
    for (int d = 0; d < 3; ++d)
      shape.corner[c][d] = cube_corners[c][d] * (1.0 + d) + 0.1 * static_cast<double>((c * c) % 3);
  for (const Vector<3>& at : {Vector<3>{0, 0, 0}, {0.3, 0.9, 0.2}, {1, 0.5, 0}})
    TEST_COMPARE(norm(shape.where(shape.place(at)) - at), <=, 1e-13);
}

TEUCHOS_UNIT_TEST(Boxes, OfABondAreHexahedraThatMatch) {
  for (const double scale : {1.0, 1e3}) {
    const auto stones = turned(running_bond(), scale, {0, 0, 0});
    const auto s = structure_of(stones, {});
    const auto meshes = mesh_stones(s);
    TEST_EQUALITY(meshes.quality.of_hexahedra, 4);
    for (std::size_t k = 0; k < stones.size(); ++k) {
      for (const auto& cell : meshes.list.blocks[k].cells) TEST_EQUALITY(cell.count, 8);
      TEST_FLOATING_EQUALITY(volume_of_hexahedra(meshes.list.blocks[k]), volume(stones[k]), 1e-10);
    }
    TEST_FLOATING_EQUALITY(area_shared(meshes.list.blocks), s.joints.area(), 1e-10);
    // Elements of a quarter of (0.4 x 0.2 x 0.2 m3)^(1/3), 0.063 m: a stone has 2 x 4 cells along, 4 across and 4 up.
    TEST_EQUALITY(meshes.list.blocks[0].cells.size(), 128u);
  }
}

TEUCHOS_UNIT_TEST(Boxes, CutsGoOnThroughStonesThatOthersDoNotCut) {
  // The middle stone is cut from above alone; the lower one has faces where that cut comes out.
  const auto stones =
      std::vector<StoneSurface>{box("low", {0, 0, 0}, {1, 1, 1}), box("mid", {0, 0, 1}, {1, 1, 2}),
                                box("left", {0, 0, 2}, {0.3, 1, 3}), box("right", {0.3, 0, 2}, {1, 1, 3})};
  const auto s = structure_of(stones, {});
  const auto meshes = mesh_stones(s);
  TEST_EQUALITY(meshes.quality.of_hexahedra, 4);
  const auto& low = meshes.list.blocks[0].position;
  TEST_ASSERT(std::any_of(low.begin(), low.end(), [](const auto& x) { return std::abs(x[0] - 0.3) < 1e-12; }));
  TEST_FLOATING_EQUALITY(area_shared(meshes.list.blocks), s.joints.area(), 1e-10);
}

TEUCHOS_UNIT_TEST(Boxes, OfWedgesAreHexahedraToo) {
  const auto stones = arch(7);
  const auto meshes = mesh_stones(structure_of(stones, {}));
  TEST_EQUALITY(meshes.quality.of_hexahedra, 7);
  double sum = 0;
  for (const auto& stone : stones) sum += volume(stone);
  TEST_FLOATING_EQUALITY(meshes.quality.volume, sum, 1e-10);
  TEST_FLOATING_EQUALITY(area_shared(meshes.list.blocks), 6 * 0.6, 1e-10);
}

TEUCHOS_UNIT_TEST(Boxes, ThatTouchAnotherShapeAreTetrahedraAsItIs) {
  auto stones = corner();  // an L, a box inside it and one below both
  for (const auto& stone : running_bond()) {
    stones.push_back(stone);
    for (auto& x : stones.back().points) x[0] += 5;
  }
  const auto list = mesh_stones(structure_of(stones, {})).list;
  for (std::size_t k = 0; k < stones.size(); ++k)
    for (const auto& cell : list.blocks[k].cells) TEST_EQUALITY(cell.count, k < 3 ? 4 : 8);
}

TEUCHOS_UNIT_TEST(Boxes, BesideStonesCutObliquelyAreTetrahedra) {
  auto above = box("above", {0.2, 0.2, 1}, {0.8, 0.8, 2});
  for (auto& x : above.points)
    x = {0.5 + 0.6 * (x[0] - 0.5) - 0.8 * (x[1] - 0.5), 0.5 + 0.8 * (x[0] - 0.5) + 0.6 * (x[1] - 0.5), x[2]};
  const auto meshes = mesh_stones(structure_of({box("low", {0, 0, 0}, {1, 1, 1}), above}, {}));
  TEST_EQUALITY(meshes.quality.of_hexahedra, 0);
  TEST_FLOATING_EQUALITY(meshes.quality.volume, 1.36, 1e-10);
}

TEUCHOS_UNIT_TEST(Boxes, HaveTheirEndsAsSetsOfFacets) {
  const auto list = mesh_stones(structure_of(running_bond(), {})).list;
  double base = 0, top = 0;
  for (const auto& block : list.blocks)
    for (const auto& facet : block.facets) {
      TEST_EQUALITY(facet.count, 4);
      Places x;
      for (const int n : facet.node) x.push_back(block.position[n]);
      (facet.set == 0 ? base : top) += area_vector(x)[2];
    }
  TEST_FLOATING_EQUALITY(base, -0.16, 1e-10);  // outward: down
  TEST_FLOATING_EQUALITY(top, 0.12, 1e-10);
}

}  // namespace
