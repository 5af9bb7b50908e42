// Meshes that cannot be computed are refused with the block, the place, the reason and a way out;
// meshes that can be are left alone.
#include "mesh/mesh_check.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <cmath>

#include "mesh/box_tree.hpp"
#include "mesh/generators.hpp"
#include "mesh/gmsh_reader.hpp"
#include "mesh/lattice.hpp"
#include "mesh/surface_mesh.hpp"
#include "unit/mesh/mesh_facts.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A structure put together by hand, each stone with nodes of its own. Edges at y = 0 are the set "ground".
struct Sketch {
  SurfaceMesh mesh;
  Sketch() { mesh.facet_sets = {"ground"}, mesh.block_sets = {"stones"}; }

  /// A stone of nx x ny quadrilaterals, the image of a rectangle.
  template <class Map>
  Sketch& stone(double x0, double y0, double x1, double y1, int nx, int ny, Map map) {
    const int first = int(mesh.position.size());
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const Vector<2> x{(x0 * (nx - i) + x1 * i) / nx, (y0 * (ny - j) + y1 * j) / ny};
        mesh.position.push_back(map(x));
        if (j == 0 && i > 0 && y0 == 0) mesh.lines.push_back({{first + i - 1, first + i}, 0});
      }
    SurfaceMesh::Surface surface{int(mesh.surfaces.size()) + 1, {0}, lattice_cells(nx, ny, CellType::quadrilateral)};
    for (Cell& cell : surface.cells)
      for (int k = 0; k < cell.count; ++k) cell.node[k] += first;
    mesh.surfaces.push_back(surface);
    return *this;
  }
  Sketch& stone(double x0, double y0, double x1, double y1, int nx, int ny) {
    return stone(x0, y0, x1, y1, nx, ny, [](const Vector<2>& x) { return x; });
  }
  BlockList<2> blocks() const { return blocks_of_surfaces(mesh); }
};

void check(const BlockSource<2>& source, const std::vector<FacetNames>& supported) {
  std::vector<Block<2>> blocks;
  for (BlockId b = 0; b < source.block_count(); ++b) blocks.push_back(source.block(b));
  check_mesh(blocks);
  check_supports(source, supported, *Tpetra::getDefaultComm());
}
std::string fault(BlockList<2> list) {
  const auto source = make_source(std::move(list));
  return input_error([&] { check(*source, {"ground"}); });
}
std::string fault(const Sketch& sketch) { return fault(sketch.blocks()); }

#define TEST_SAYS(message, part) TEST_ASSERT(holds(message, part) || (out << message << "\n", false))

// Two stones of 1 m x 0.5 m side by side, edges of 0.25 m.
Sketch two_stones() { return Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(1, 0, 2, 0.5, 4, 2); }

TEUCHOS_UNIT_TEST(MeshCheck, LeavesGoodMeshesAlone) {
  TEST_EQUALITY(fault(two_stones()), "");
  WallParameters wall;
  wall.openings["door"] = {1, 2, 0, 1};
  ArchParameters arch;
  arch.pier_height = 2;
  arch.voussoirs = 9;
  TEST_EQUALITY(input_error([&] { check(*make_wall(wall), {"base"}); }), "");
  TEST_EQUALITY(input_error([&] { check(*make_arch(arch), {"springing left", "springing right"}); }), "");
  arch.cells = CellType::triangle;
  TEST_EQUALITY(input_error([&] { check(*make_arch(arch), {"springing left", "springing right"}); }), "");
}

TEUCHOS_UNIT_TEST(MeshCheck, LeavesOpenJointsAndWedgesAlone) {
  // A gap of a fifth of an edge, and a joint that opens by 15 degrees from a common corner.
  TEST_EQUALITY(fault(Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(1.05, 0, 2, 0.5, 4, 2)), "");
  const auto leaning = [](const Vector<2>& x) {
    return Vector<2>{1 + (x[0] - 1) * std::cos(0.26) + x[1] * std::sin(0.26),
                     x[1] * std::cos(0.26) - (x[0] - 1) * std::sin(0.26)};
  };
  Sketch hinge = two_stones();
  hinge.stone(0, 0.5, 1, 1, 4, 2);
  hinge.stone(1, 0.0, 2, 0.5, 4, 2, [&](const Vector<2>& x) { return leaning(x) + Vector<2>{0, 0.5}; });
  hinge.mesh.surfaces.erase(hinge.mesh.surfaces.begin() + 1);  // the leaning stone hangs beside, over nothing
  hinge.mesh.lines.clear();
  hinge.mesh.lines.push_back({{0, 1}, 0});
  hinge.mesh.lines.push_back({{int(hinge.mesh.position.size()) - 15, int(hinge.mesh.position.size()) - 14}, 0});
  TEST_EQUALITY(fault(hinge), "");
}

TEUCHOS_UNIT_TEST(MeshCheck, ABlockWithoutCells) {
  Sketch s = two_stones();
  s.mesh.surfaces[1].cells.clear();
  s.mesh.lines.resize(4);
  TEST_SAYS(fault(s), "mesh: surface 2 (stones) has no cells");
  TEST_SAYS(fault(s), "Mesh.SaveAll = 1");
}

TEUCHOS_UNIT_TEST(MeshCheck, CoordinatesThatAreNoNumbers) {
  Sketch s = two_stones();
  s.mesh.position[17] = {1.25, NAN};
  TEST_SAYS(fault(s), "mesh: surface 2 (stones), node 2 at (1.25, nan) m is nowhere");
  s.mesh.position[17] = {INFINITY, 0};
  TEST_SAYS(fault(s), "at (inf, 0) m is nowhere");
}

TEUCHOS_UNIT_TEST(MeshCheck, ANodeWithoutCell) {
  BlockList<2> list = two_stones().blocks();
  list.blocks[0].position.push_back({7, 8});
  list.blocks[0].vertex.push_back(1000);
  TEST_SAYS(fault(list), "mesh: surface 1 (stones), node 15 at (7, 8) m belongs to no cell");
}

TEUCHOS_UNIT_TEST(MeshCheck, AnInvertedCell) {
  Sketch s = two_stones();
  s.mesh.position[6] = {0.6, 0.25};  // past its neighbour at 0.5
  const std::string said = fault(s);
  TEST_SAYS(said, "mesh: surface 1 (stones), cell 1 with a corner at");
  TEST_SAYS(said, "is inverted\n  (its Jacobian is -");
  TEST_SAYS(said, "Mesh the surface again");
}

TEUCHOS_UNIT_TEST(MeshCheck, ACornerThatPointsInwardIsInvertedToo) {
  Sketch s;
  s.mesh.position = {{0, 0}, {2, 0}, {0.4, 0.4}, {0, 2}};  // an arrowhead: its area is positive, one Jacobian is not
  s.mesh.surfaces = {{1, {0}, {Cell{{0, 1, 2, 3}, 4}}}};
  s.mesh.lines = {{{0, 1}, 0}};
  TEST_SAYS(fault(s), "mesh: surface 1 (stones), cell 0 with a corner at (0.4, 0.4) m is inverted");
}

TEUCHOS_UNIT_TEST(MeshCheck, ASliver) {
  const auto thin = [](double height) {
    Sketch s;
    s.mesh.position = {{0, 0}, {1, 0}, {0.5, height}};
    s.mesh.surfaces = {{1, {0}, {Cell{{0, 1, 2}, 3}}}};
    s.mesh.lines = {{{0, 1}, 0}};
    return s;
  };
  TEST_SAYS(fault(thin(0.005)),
            "cell 0 with a corner at (0, 0) m is a sliver\n  (the angle of that corner is 0.572939 degrees");
  TEST_SAYS(fault(thin(0)), "is a sliver\n  (the angle of that corner is 0 degrees");
  TEST_EQUALITY(fault(thin(0.01)), "");  // 1.15 degrees
}

TEUCHOS_UNIT_TEST(MeshCheck, CellsThatLieOnEachOther) {
  Sketch s = two_stones();
  s.mesh.surfaces[0].cells.push_back(s.mesh.surfaces[0].cells[0]);
  TEST_SAYS(fault(s), "mesh: surface 1 (stones), the edge from (0, 0) m to (0.25, 0) m has two cells on the same side");
}

TEUCHOS_UNIT_TEST(MeshCheck, ABlockInPieces) {
  Sketch s = two_stones();
  auto& cells = s.mesh.surfaces[0].cells;
  cells.erase(cells.begin() + 5);
  cells.erase(cells.begin() + 1);  // the second column of four is gone
  s.mesh.lines.erase(s.mesh.lines.begin() + 1);
  TEST_SAYS(fault(s), "mesh: surface 1 (stones) is in pieces: cell 0 at (0, 0) m and cell 1 at (0.5, 0) m");
  TEST_SAYS(fault(s), "Make each piece a surface of its own");
}

TEUCHOS_UNIT_TEST(MeshCheck, TheSameStoneTwice) {
  TEST_SAYS(
      fault(Sketch().stone(0, 0, 1, 1, 2, 2).stone(0, 0, 1, 1, 2, 2)),
      "mesh: surface 1 (stones), surface 2 (stones) lie on the same side of the edge from (0, 0) m to (0.5, 0) m");
}

TEUCHOS_UNIT_TEST(MeshCheck, ThreeStonesAtOneEdge) {
  const std::string said = fault(two_stones().stone(1, 0, 2, 0.5, 4, 2));
  TEST_SAYS(
      said,
      "mesh: the edge from (1, 0) m to (1, 0.25) m belongs to surface 1 (stones), surface 2 (stones) and surface 3");
  TEST_SAYS(said, "Remove doubled surfaces");
}

TEUCHOS_UNIT_TEST(MeshCheck, BordersWithDifferentDivisions) {
  const std::string said = fault(Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(1, 0, 2, 0.5, 4, 3));
  TEST_SAYS(said, "mesh: surface 1 (stones) and surface 2 (stones) touch without matching nodes");
  TEST_SAYS(said, "0 m apart, with 1 common vertex");
  TEST_SAYS(said, "Let both surfaces share one curve");
}

TEUCHOS_UNIT_TEST(MeshCheck, StonesShiftedAlongTheirJoint) {
  // Half an edge to the right: no common vertex at all.
  TEST_SAYS(fault(Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(0.125, 0.5, 1.125, 1, 4, 2)),
            "surface 1 (stones) and surface 2 (stones) touch without matching nodes");
}

TEUCHOS_UNIT_TEST(MeshCheck, BordersThatMissEachOtherByAMillimetre) {
  // 1 mm on edges of 0.25 m: a slip of the pen, not a joint somebody left open.
  const std::string said = fault(Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(1.001, 0, 2, 0.5, 4, 2));
  TEST_SAYS(said, "surface 1 (stones) and surface 2 (stones) nearly touch, but their nodes do not match");
  TEST_SAYS(said, "0.001 m apart, with 0 common vertices");
}

TEUCHOS_UNIT_TEST(MeshCheck, ChordsOfDifferentLengthAlongOneArc) {
  const auto polar = [](const Vector<2>& x) { return Vector<2>{x[0] * std::cos(x[1]), x[0] * std::sin(x[1])}; };
  const auto rings = [&](int inner, int outer) {
    Sketch s;
    s.stone(1, 0, 2, 1.5, 4, inner, polar).stone(2, 0, 3, 1.5, 4, outer, polar);
    return fault(s);
  };
  TEST_EQUALITY(rings(6, 6), "");
  TEST_SAYS(rings(6, 12), "nearly touch, but their nodes do not match");
  TEST_SAYS(rings(12, 6), "nearly touch, but their nodes do not match");
}

TEUCHOS_UNIT_TEST(MeshCheck, StonesThatOverlap) {
  const std::string said = fault(Sketch().stone(0, 0, 1, 0.5, 4, 2).stone(0.9, 0, 2, 0.5, 4, 2));
  TEST_SAYS(said, "mesh: surface 1 (stones) and surface 2 (stones) overlap near (1, 0.09");  // on the end of stone 1
  TEST_SAYS(said, "BooleanFragments");
}

TEUCHOS_UNIT_TEST(MeshCheck, AStoneInsideAnother) {
  TEST_SAYS(fault(Sketch().stone(0, 0, 3, 3, 1, 1).stone(1.1, 1.2, 1.3, 1.4, 1, 1)),
            "mesh: surface 1 (stones) and surface 2 (stones) overlap near (1.1, 1.2) m");
}

TEUCHOS_UNIT_TEST(MeshCheck, BarsThatCrossWithoutANodeInsideEachOther) {
  // Middles of the cells are at 0.5 and 2 m from the crossing.
  Sketch s;
  s.stone(0, 2, 3, 2.1, 1, 1).stone(0.2, 0, 0.4, 4, 1, 1);
  TEST_SAYS(fault(s), "overlap near (");
}

TEUCHOS_UNIT_TEST(MeshCheck, AStoneThatNothingHolds) {
  const std::string said = fault(two_stones().stone(3, 1, 4, 2, 2, 2));
  TEST_SAYS(said,
            "mesh: surface 3 (stones) has neither support nor joint\n  (nothing holds it, so there is no equilibrium)");
  TEST_SAYS(said, "supported set (now: ground)");
}

TEUCHOS_UNIT_TEST(MeshCheck, StonesThatHoldOnlyEachOther) {
  TEST_SAYS(fault(two_stones().stone(3, 1, 4, 2, 2, 2).stone(4, 1, 5, 2, 2, 2)),
            "mesh: surface 3 (stones) and 1 more block joined to it have no support");
  WallParameters wall;
  wall.openings["slot"] = {-1, 9, 0.25, 0.5};  // all of course 1
  TEST_SAYS(input_error([&] { check_supports(*make_wall(wall), {"base"}, *Tpetra::getDefaultComm()); }),
            "mesh: block 8 (course 2, stone 0) and 50 more blocks joined to it have no support");
}

TEUCHOS_UNIT_TEST(MeshCheck, AStoneThatStandsOnAPoint) {
  TEST_SAYS(fault(two_stones().stone(2, 0.5, 3, 1, 4, 2)), "it touches other blocks in single points only");
}

TEUCHOS_UNIT_TEST(MeshCheck, WithoutAnySupportedSetNothingNeedsSupport) {
  const auto source = make_source(two_stones().stone(3, 1, 4, 2, 2, 2).blocks());
  TEST_EQUALITY(input_error([&] { check(*source, {}); }), "");
}

TEUCHOS_UNIT_TEST(MeshCheck, EveryRankThrowsTheSame) {
  const auto comm = Tpetra::getDefaultComm();
  const auto source = make_source(two_stones().stone(3, 1, 4, 2, 2, 2).blocks());
  const std::string said = input_error([&] { check(*source, {"ground"}); });
  TEST_SAYS(said, "mesh: surface 3 (stones) has neither support nor joint");
  comm->barrier();  // reached by all, or the test hangs
}

TEUCHOS_UNIT_TEST(MeshCheck, FaultsAreFoundInAnyDirection) {
  for (int turn = 0; turn < 12; ++turn) {
    const double angle = 0.1 + turn * 0.55;
    const auto turned = [angle](const Vector<2>& x) {
      return Vector<2>{x[0] * std::cos(angle) - x[1] * std::sin(angle),
                       x[0] * std::sin(angle) + x[1] * std::cos(angle)};
    };
    const auto pair = [&](double from, int ny) {
      Sketch s;
      return fault(s.stone(0, 0, 1, 0.5, 4, 2, turned).stone(from, 0, 2, 0.5, 4, ny, turned));
    };
    TEST_EQUALITY(pair(1, 2), "");
    TEST_SAYS(pair(1, 3), "touch without matching nodes");
    TEST_SAYS(pair(1.001, 2), "nearly touch");
    TEST_SAYS(pair(0.9, 2), "overlap");
  }
}

TEUCHOS_UNIT_TEST(BoxTree, FindsExactlyTheBoxesThatOverlap) {
  // Boxes of sizes from 1 to 1/64 scattered by a multiplicative sequence.
  std::vector<Box<2>> boxes;
  for (int i = 1; i <= 300; ++i) {
    const double x = (i * 7919 % 1009) / 100.0, y = (i * 6101 % 997) / 100.0, size = 1.0 / (1 << i % 7);
    boxes.push_back({{x, y}, {x + size, y + size / 2}});
  }
  const BoxTree<2> tree(boxes);
  for (const Box<2>& box : boxes) {
    std::vector<int> found, expected;
    tree.visit_overlaps(box, [&](int i) { found.push_back(i); });
    for (int i = 0; i < int(boxes.size()); ++i)
      if (boxes[i].overlaps(box)) expected.push_back(i);
    std::sort(found.begin(), found.end());
    TEST_ASSERT(found == expected);
  }
  BoxTree<2>({}).visit_overlaps(boxes[0], [&](int) { success = false; });
}

}  // namespace
