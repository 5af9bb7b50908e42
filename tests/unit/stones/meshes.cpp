// Tetrahedra in stones: they fill them, and stones have the same nodes where they touch.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "joints/joint_finder_in_space.hpp"
#include "stones/filled_stones.hpp"
#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

double volume_of(const Block<3>& block) {
  double sum = 0;
  for (const auto& cell : block.cells) {
    const auto x = [&](int k) { return block.position[cell.node[k]]; };
    sum += dot(x(3) - x(0), cross(x(1) - x(0), x(2) - x(0))) / 6;
  }
  return sum;
}

using Face = std::array<VertexId, 3>;

/// Faces of cells that no other cell of the block has, by vertices.
std::set<Face> border_of(const Block<3>& block) {
  std::map<Face, int> uses;
  for (const auto& cell : block.cells)
    for (int k = 0; k < 4; ++k) {
      Face face;
      for (int i = 0; i < 3; ++i) face[i] = block.vertex[cell.node[(k + 1 + i) % 4]];
      std::sort(face.begin(), face.end());
      ++uses[face];
    }
  std::set<Face> border;
  for (const auto& [face, number] : uses)
    if (number == 1) border.insert(face);
  return border;
}

/// [m2] of faces that two blocks have.
double area_shared(const std::vector<Block<3>>& blocks) {
  std::map<VertexId, Vector<3>> place;
  std::map<Face, int> uses;
  for (const auto& block : blocks) {
    for (std::size_t n = 0; n < block.vertex.size(); ++n) place[block.vertex[n]] = block.position[n];
    for (const auto& face : border_of(block)) ++uses[face];
  }
  double sum = 0;
  for (const auto& [face, number] : uses)
    if (number == 2) sum += norm(cross(place[face[1]] - place[face[0]], place[face[2]] - place[face[0]])) / 2;
  return sum;
}

StonesParameters tetrahedra() {
  StonesParameters p;
  p.cells = StoneCells::tetrahedra;
  return p;
}

void check(const StoneStructure& s, const StoneMeshes& meshes, Teuchos::FancyOStream& out, bool& success) {
  TEST_EQUALITY(meshes.list.blocks.size(), s.stones.size());
  constexpr double drawn = 1e-12;  // [m] to which places in such stones are known (mesh/alike_blocks.hpp)
  std::map<VertexId, Vector<3>> place;
  std::set<std::array<long long, 3>> places;
  for (const auto& block : meshes.list.blocks) {
    for (const auto& cell : block.cells) TEST_EQUALITY(cell.count, 4);
    for (std::size_t n = 0; n < block.vertex.size(); ++n)
      TEST_COMPARE(norm(place.emplace(block.vertex[n], block.position[n]).first->second - block.position[n]), <=,
                   drawn);
  }
  for (const auto& [vertex, x] : place)
    places.insert({std::llround(x[0] * 1e9), std::llround(x[1] * 1e9), std::llround(x[2] * 1e9)});
  TEST_EQUALITY(place.size(), places.size());  // equal places have equal vertices
  double cells = 0;
  for (std::size_t c = 0; c < s.imprint.cells.size(); ++c)
    if (s.imprint.other[c] >= 0) cells += s.imprint.cells[c].area / 2;
  // The area of cells is that of their shadow on a facet, which is 1e-4 smaller where noise tilts them by a hundredth.
  TEST_COMPARE(std::abs(area_shared(meshes.list.blocks) - cells), <=, 1e-3 * cells);
}

TEUCHOS_UNIT_TEST(StoneMeshes, FillStonesAndMatchOnJoints) {
  const std::vector<std::vector<StoneSurface>> cases{
      arch(5), corner(), running_bond(), {box("slab", {0, 0, 0}, {3, 3, 1}), box("post", {1, 1, 1}, {2, 2, 2})}};
  for (const auto& stones : cases) {
    const auto s = structure_of(stones, tetrahedra());
    const auto meshes = mesh_stones(s);
    check(s, meshes, out, success);
    double sum = 0;
    for (std::size_t k = 0; k < stones.size(); ++k) {
      TEST_FLOATING_EQUALITY(volume_of(meshes.list.blocks[k]), volume(stones[k]), 1e-10);
      sum += volume(stones[k]);
    }
    TEST_FLOATING_EQUALITY(meshes.quality.volume, sum, 1e-10);
    TEST_COMPARE(meshes.quality.least_dihedral, >, 5);
    TEST_COMPARE(std::abs(area_shared(meshes.list.blocks) - s.joints.area()), <=, 1e-10 * s.joints.area());
  }
}

TEUCHOS_UNIT_TEST(StoneMeshes, OfMeasuredStonesFillThemToo) {
  for (const double noise : {1e-4, 5e-4, 2e-3}) {
    StonesParameters p = tetrahedra();
    p.joint_tolerance = 4 * noise;
    const auto s = structure_of(measured(arch(5), noise), p);
    const auto meshes = mesh_stones(s);
    check(s, meshes, out, success);
    double sum = 0;
    for (const auto& stone : s.stones) sum += volume(stone);
    // Corners move by up to the weld distance: 12 times the noise, on faces of 16 m2 for 4.7 m3 in all.
    TEST_COMPARE(std::abs(meshes.quality.volume - sum), <=, 12 * noise);
  }
}

TEUCHOS_UNIT_TEST(StoneMeshes, AreAsFineInOtherUnits) {
  // gmsh sees every piece in units of its size; round-off of coordinates may still turn a choice it makes.
  const auto here = mesh_stones(structure_of(running_bond(), tetrahedra()));
  for (const double scale : {1e3, 1e-3}) {
    const auto there = mesh_stones(structure_of(turned(running_bond(), scale, {0, 0, 0}), tetrahedra()));
    TEST_COMPARE(std::abs(double(there.quality.cells) - double(here.quality.cells)), <=,
                 0.1 * double(here.quality.cells));
    TEST_FLOATING_EQUALITY(there.quality.volume, scale * scale * scale * here.quality.volume, 1e-9);
  }
}

// Of 5 x 4 stones in a wall without ends those inside are alike, and at each of its sides and corners there are others:
// free faces are not cut by what they do not touch, so here they are as those inside.
TEUCHOS_UNIT_TEST(StoneMeshes, OfStonesThatAreTranslatesAreMadeOnce) {
  const auto stones = honeycomb(5, 4);
  const auto s = structure_of(stones, tetrahedra());
  const auto meshes = mesh_stones(s);
  check(s, meshes, out, success);
  TEST_EQUALITY(meshes.quality.filled, 1);
  for (std::size_t k = 0; k < stones.size(); ++k) {
    TEST_FLOATING_EQUALITY(volume_of(meshes.list.blocks[k]), volume(stones[k]), 1e-10);
    TEST_EQUALITY(meshes.list.blocks[k].cells.size(), meshes.list.blocks[0].cells.size());
  }
  TEST_EQUALITY(mesh_stones(structure_of(arch(5), tetrahedra())).quality.filled, 5);  // each turned
  // A stone in the other order of points and faces, seen from the other side of every joint.
  auto backward = honeycomb(2, 2);
  std::reverse(backward.begin(), backward.end());
  TEST_EQUALITY(mesh_stones(structure_of(backward, tetrahedra())).quality.filled, 1);
}

/// A stone on another whose top is drawn over places of the plane of x and z.
std::vector<StoneSurface> on_top_of(const std::vector<Vector<2>>& top) {
  std::vector<Vector<2>> below{{-1, -1}, {1, -1}}, above(top);
  below.insert(below.end(), top.rbegin(), top.rend());
  above.insert(above.end(), {{1, 1}, {-1, 1}});
  return {prism("below", below, 0, 1, 0, 2), prism("above", above, 0, 1, 0, 2)};
}

std::vector<PointInSpace> points_between(const std::vector<StoneSurface>& stones) {
  const auto blocks = mesh_stones(structure_of(stones, tetrahedra())).list.blocks;
  return points_of_joint(blocks[0], border_facets<3>({blocks[0]}), blocks[1], border_facets<3>({blocks[1]}));
}

TEUCHOS_UNIT_TEST(StoneMeshes, HavePointsOfTheirOwnOnBothSidesOfAFoldThatIsDrawn) {
  const auto points = points_between(on_top_of({{-1, -0.1}, {0, 0}, {1, -0.1}}));
  std::map<VertexId, int> at_vertex;
  for (const auto& p : points) {
    ++at_vertex[p.vertex];
    TEST_FLOATING_EQUALITY(std::abs(p.normal[0] / p.normal[2]), 0.1, 1e-9);
  }
  int folded = 0;
  for (const auto& [vertex, count] : at_vertex) folded += count == 2;
  TEST_COMPARE(folded, >=, 3);
}

TEUCHOS_UNIT_TEST(StoneMeshes, HaveMeanNormalsBetweenFacetsOfSomethingCurved) {
  const auto points = points_between(on_top_of({{-1, -0.06}, {-0.4, 0}, {0.4, 0}, {1, -0.06}}));  // by 5.7 degrees each
  const auto flat = points_between(on_top_of({{-1, -0.03}, {-0.4, 0}, {0.4, 0}, {1, -0.03}}));    // by 2.9
  const auto doubled = [](const std::vector<PointInSpace>& all) {
    std::set<VertexId> vertices;
    for (const auto& p : all) vertices.insert(p.vertex);
    return all.size() - vertices.size();
  };
  TEST_COMPARE(doubled(points), >=, 4);
  TEST_EQUALITY(doubled(flat), 0);
}

TEUCHOS_UNIT_TEST(StoneMeshes, HaveContactPointsThatStandForTheWholeJoint) {
  for (const auto cells : {StoneCells::tetrahedra, StoneCells::by_shape}) {
    StonesParameters p;
    p.cells = cells;
    const auto s = structure_of(running_bond(), p);
    const auto blocks = mesh_stones(s).list.blocks;
    for (const auto& joint : s.joints.joints) {
      const auto &i = blocks[joint.stone[0]], &j = blocks[joint.stone[1]];
      double area = 0;
      for (const auto& point : points_of_joint(i, border_facets<3>({i}), j, border_facets<3>({j}))) {
        area += point.area;
        TEST_COMPARE(norm(point.normal - joint.normal), <=, 1e-12);
        TEST_ASSERT(i.vertex[point.node_i] == point.vertex && j.vertex[point.node_j] == point.vertex);
      }
      TEST_FLOATING_EQUALITY(area, joint.area, 1e-12);
    }
  }
}

TEUCHOS_UNIT_TEST(StoneMeshes, NameSetsOfStonesAndOfTheirEnds) {
  auto stones = running_bond();
  stones[1].support = true;
  stones.push_back(box("far", {3, 0, 0.2}, {3.2, 0.2, 0.4}));
  const auto list = mesh_stones(structure_of(stones, tetrahedra())).list;
  TEST_ASSERT((list.block_sets == SetNames{"a", "b", "c", "d", "far", "supports"}));
  TEST_ASSERT((list.blocks[1].sets == std::vector<int>{1, 5}));
  TEST_ASSERT((list.facet_sets == std::vector<std::string>{"base", "top", "faces"}));
  for (std::size_t b = 0; b < list.blocks.size(); ++b) {
    double base = 0, top = 0, all = 0;
    for (const auto& facet : list.blocks[b].facets) {
      const auto x = [&](int k) { return list.blocks[b].position[facet.node[k]]; };
      (facet.set == 0 ? base : facet.set == 1 ? top : all) += norm(cross(x(1) - x(0), x(2) - x(0))) / 2;
      if (facet.set < 2) TEST_COMPARE(std::abs(x(0)[2] - (facet.set == 0 ? 0.0 : 0.4)), <=, 1e-12);
    }
    TEST_FLOATING_EQUALITY(base, b < 2 ? 0.08 : 0.0, 1e-10);
    TEST_FLOATING_EQUALITY(top, b == 2 ? 0.08 : b > 2 ? 0.04 : 0.0, 1e-10);
    const double length = b < 3 ? 0.4 : 0.2;
    TEST_FLOATING_EQUALITY(all, 4 * 0.2 * length + 2 * 0.2 * 0.2, 1e-10);
  }
}

TEUCHOS_UNIT_TEST(StoneMeshes, ASurfaceThatCannotBeFilledFailsAlone) {
  const auto stone = box("", {0, 0, 0}, {1, 1, 1});
  ClosedMesh good{
      stone.points,
      {},
      1.0,
  };
  for (const auto& face : stone.faces) {
    good.triangles.push_back({face[0], face[1], face[2]});
    good.triangles.push_back({face[0], face[2], face[3]});
  }
  ClosedMesh crossed = good;
  crossed.nodes[6] = {-1, -1, -1};  // a corner pulled through the opposite one
  const auto meshes = filled({good, crossed, good});
  TEST_ASSERT(meshes[0].failure.empty() && !meshes[0].cells.empty());
  TEST_ASSERT(!meshes[1].failure.empty());
  TEST_ASSERT(meshes[2].cells == meshes[0].cells);
}

double area_of(const FlatMesh& mesh, const FlatDomain& domain) {
  Polygon nodes;
  for (const auto& loop : domain.loops) nodes.insert(nodes.end(), loop.begin(), loop.end());
  nodes.insert(nodes.end(), mesh.inside.begin(), mesh.inside.end());
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area({nodes[t[0]], nodes[t[1]], nodes[t[2]]});
  return sum;
}

// As where measured corners fall on each other: what is cut out of a face touches its border from within, a face hangs
// together in a corner, or two holes touch.
TEUCHOS_UNIT_TEST(Meshes, FacesWhoseBordersTouchThemselvesAreMeshed) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const FlatDomain hole_at_a_corner{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 1}}}, 0.8};
  const FlatDomain two_parts{{{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}}, 0.8};
  const FlatDomain holes_that_touch{{square, {{2, 2}, {1, 3}, {3, 3}}, {{2, 2}, {3, 1}, {1, 1}}}, 0.8};
  const FlatDomain island{{square, {{1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}, {2.5, 1.5}, {1.5, 2.5}}}, 0.8};
  const std::vector<FlatDomain> domains{hole_at_a_corner, two_parts, holes_that_touch, island};
  const std::vector<double> areas{16 - 1.5, 8, 16 - 2, 16 - 4 + 1};
  const auto meshes = meshed(domains);
  for (std::size_t k = 0; k < domains.size(); ++k) {
    TEST_EQUALITY(meshes[k].failure, "");
    TEST_FLOATING_EQUALITY(area_of(meshes[k], domains[k]), areas[k], 1e-12);
  }
}

}  // namespace
