// Files of gmsh become blocks, on every rank alike, and what is wrong with a file is said on every rank.
#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include "mesh/block_source.hpp"
#include "unit/mesh/gmsh_files.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

double width_of(const Block<2>& block) {
  double from = INFINITY, to = -INFINITY;
  for (const Vector<2>& x : block.position) from = std::min(from, x[0]), to = std::max(to, x[0]);
  return to - from;
}

TEUCHOS_UNIT_TEST(Gmsh, SurfacesBecomeBlocksInTheOrderOfTheirTags) {
  const auto source = read(geo("two_stones.geo"));
  check_source(*source, out, success);
  TEST_EQUALITY(source->block_count(), 2);
  TEST_EQUALITY(source->block(0).name, "surface 4 (group 7, both)");
  TEST_EQUALITY(source->block(1).name, "surface 17 (west, both)");
  // The shared curve of 1 m in elements of 0.5 m has three nodes.
  TEST_ASSERT(graph_of(*source).shared_vertices == (std::vector<int>{3, 3}));
}

TEUCHOS_UNIT_TEST(Gmsh, PhysicalGroupsBecomeSetsAndAnInnerCurveBelongsToBothBlocks) {
  const auto source = read(geo("two_stones.geo"));
  TEST_ASSERT((source->block_sets() == SetNames{"west", "group 7", "both"}));
  TEST_ASSERT((source->facet_sets() == std::vector<std::string>{"base", "joint"}));
  TEST_ASSERT((source->block(0).sets == std::vector<int>{1, 2}));
  const auto base = facet_midpoints(*source, "base"), joint = facet_midpoints(*source, "joint");
  TEST_EQUALITY(base.size(), 4u);
  for (const Vector<2>& x : base) TEST_EQUALITY(x[1], 0.0);
  TEST_EQUALITY(joint.size(), 4u);  // two edges, each seen from both sides
  for (const Vector<2>& x : joint) TEST_EQUALITY(x[0], 1.0);
}

TEUCHOS_UNIT_TEST(Gmsh, NumbersOfTheSceneReachTheFileAndDoNotOutliveIt) {
  const auto as_written = read(geo("two_stones.geo"));
  GmshParameters p = geo("two_stones.geo");
  p.element_size = 0.125;
  p.geometry["width"] = 2.5;
  const auto finer = read(p);
  TEST_FLOATING_EQUALITY(width_of(finer->block(1)), 2.5, 1e-15);
  TEST_EQUALITY(graph_of(*finer).shared_vertices[0], 9);
  const auto again = read(geo("two_stones.geo"));
  TEST_EQUALITY(again->node_count(1), as_written->node_count(1));
  TEST_FLOATING_EQUALITY(width_of(again->block(1)), 1.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Gmsh, RecombinesForQuadrilaterals) {
  GmshParameters p = geo("two_stones.geo");
  p.cells = CellType::quadrilateral;
  const auto source = read(p);
  check_source(*source, out, success);
  for (BlockId b = 0; b < 2; ++b)
    for (const Cell& cell : source->block(b).cells) TEST_EQUALITY(cell.count, 4);
}

TEUCHOS_UNIT_TEST(Gmsh, StonesMeshedApartShareVerticesWhereTheirNodesCoincide) {
  // The beds are 1e-11 m apart at one end, edges are 0.14 m: 7e-11 of an edge, below one millionth.
  const auto source = read(geo("meshed_apart.geo"));
  check_source(*source, out, success);
  TEST_ASSERT(graph_of(*source).shared_vertices == (std::vector<int>{6, 6}));
  TEST_EQUALITY(facet_midpoints(*source, "bed").size(),
                10u);  // tagged on one of two coincident curves: both blocks have it
}

TEUCHOS_UNIT_TEST(Gmsh, AMeshFileGivesTheSameBlocksAsItsGeometry) {
  // Version 4.1, written by hand: a square of two triangles above one of a quadrilateral.
  const auto source = read(written("two.msh", R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "base"
2 3 "stone"
$EndPhysicalNames
$Entities
0 1 2 0
1 0 0 0 1 0 0 1 1 0
1 0 0 0 1 1 0 1 3 1 1
2 0 1 0 1 2 0 1 3 0
$EndEntities
$Nodes
3 6 1 6
1 1 0 2
1
2
0 0 0
1 0 0
2 1 0 2
3
4
1 1 0
0 1 0
2 2 0 2
5
6
1 2 0
0 2 0
$EndNodes
$Elements
3 4 1 4
1 1 1 1
1 1 2
2 1 3 1
2 1 2 3 4
2 2 2 2
3 4 3 5
4 4 5 6
$EndElements
)"));
  check_source(*source, out, success);
  TEST_EQUALITY(source->block_count(), 2);
  TEST_EQUALITY(source->block(0).name, "surface 1 (stone)");
  TEST_EQUALITY(source->block(0).cells[0].count, 4);
  TEST_EQUALITY(source->block(1).cells.size(), 2u);
  TEST_EQUALITY(facet_midpoints(*source, "base").size(), 1u);
}

TEUCHOS_UNIT_TEST(Gmsh, EveryRankHoldsTheSameBlocks) {
  const auto comm = Tpetra::getDefaultComm();
  const auto source = read(geo("two_stones.geo"));
  double mine = 0, sum = 0;
  for (BlockId b = 0; b < 2; ++b) {
    const Block<2> block = source->block(b);
    for (std::size_t n = 0; n < block.position.size(); ++n)
      mine += dot(block.position[n], {1.0 + double(n), 3.0}) + double(block.vertex[n] * (b + 1));
    for (const TaggedFacet& f : block.facets) mine += f.node[0] * 5 + f.node[1] + f.set * 100;
    for (const Cell& cell : block.cells) mine += cell.node[0] + 7 * cell.node[cell.count - 1];
    mine += double(block.name.size());
  }
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, 1, &mine, &sum);
  TEST_EQUALITY(sum, mine * comm->getSize());  // one, two or four equal summands add without rounding
}

TEUCHOS_UNIT_TEST(Gmsh, TheSceneChoosesBetweenFileAndGenerators) {
  MeshParameters p;
  p.gmsh = geo("two_stones.geo");
  TEST_EQUALITY(make_block_source<2>(p, *Tpetra::getDefaultComm())->block_count(), 2);
  p.type = MeshType::arch;
  TEST_EQUALITY(make_block_source<2>(p, *Tpetra::getDefaultComm())->block_count(), 31);
  p.type = MeshType::wall;
  TEST_EQUALITY(make_block_source<2>(p, *Tpetra::getDefaultComm())->block_count(), 68);
}

TEUCHOS_UNIT_TEST(Gmsh, AFileThatIsNotThereIsRefused) {
  TEST_ASSERT(holds(refusal(geo("nowhere.geo")), "nowhere.geo\n  cannot be read (sought as /"));
  TEST_ASSERT(holds(refusal(geo("")), "cannot be read"));
  TEST_ASSERT(holds(refusal(written("stone.stl", "solid")), "is neither .geo nor .msh"));
}

TEUCHOS_UNIT_TEST(Gmsh, SyntaxErrorsAreQuotedWithTheirLine) {
  const std::string said = refusal(written("syntax.geo", "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0;\n"));
  TEST_ASSERT(holds(said, "gmsh could not read the file"));
  TEST_ASSERT(holds(said, "syntax.geo', line 2: syntax error"));
}

TEUCHOS_UNIT_TEST(Gmsh, DamagedMeshFilesAreRefused) {
  TEST_ASSERT(holds(refusal(written("damaged.msh", "$MeshFormat\n9.9 0 8\n$EndMeshFormat\n")), "damaged.msh"));
  TEST_ASSERT(holds(refusal(written("text.msh", "no mesh\n")), "text.msh"));
  TEST_ASSERT(holds(refusal(written("cut.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n")),
                    "cut.msh"));
}

TEUCHOS_UNIT_TEST(Gmsh, FilesWithoutSurfaceOrOutOfThePlaneAreRefused) {
  TEST_ASSERT(holds(refusal(written("curves.geo", square)), "has no surface; every surface becomes a block"));
  TEST_ASSERT(holds(refusal(written("deep.geo",
                                    "Point(1) = {0,0,2,1}; Point(2) = {1,0,2,1}; Point(3) = {1,1,2,1};\n"
                                    "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,1};\n"
                                    "Curve Loop(1) = {1,2,3}; Plane Surface(1) = {1};\n")),
                    "has nodes at z = 2 m"));
}

TEUCHOS_UNIT_TEST(Gmsh, CellsOfSecondOrderAreRefused) {
  const std::string said = refusal(written("second.geo", square + "Plane Surface(1) = {1}; Mesh.ElementOrder = 2;\n"));
  TEST_ASSERT(holds(said, "has on surface 1 cells with 6 nodes"));
  TEST_ASSERT(holds(said, "Set Mesh.ElementOrder = 1"));
}

TEUCHOS_UNIT_TEST(Gmsh, CurvesThatBoundNothingAreRefused) {
  const std::string said = refusal(written("loose.geo", square + R"(Plane Surface(1) = {1};
Point(5) = {3,0,0,1}; Point(6) = {4,0,0,1}; Line(9) = {5,6}; Physical Curve("ground") = {9};)"));
  TEST_ASSERT(holds(said, "the set of curves \"ground\" lies on the border of no block"));
  TEST_ASSERT(holds(refusal(written("all.geo", square + "Plane Surface(1) = {1}; Physical Surface(\"all\") = {1};")),
                    "has a physical group named \"all\""));
}

TEUCHOS_UNIT_TEST(Gmsh, NumbersTheFileDoesNotOfferAreRefused) {
  GmshParameters p = geo("two_stones.geo");
  p.geometry["widht"] = 2;
  TEST_ASSERT(holds(refusal(p), "gmsh > geometry > widht = 2\n  cannot be set"));
  TEST_ASSERT(holds(refusal(p), "(it has: element_size, recombine, width)"));
  p.geometry = {{"width", NAN}};
  TEST_ASSERT(holds(refusal(p), "must be a finite number"));
  p = written("plain.geo",
              "// DefineConstant[ element_size = 1 ];\nelement_size = 1;\n" + square + "Plane Surface(1) = {1};");
  TEST_EQUALITY(refusal(p), "");
  p.cells = CellType::quadrilateral;
  TEST_ASSERT(holds(refusal(p), "gmsh > cells = quadrilateral\n  cannot be set"));
}

TEUCHOS_UNIT_TEST(Gmsh, QuadrilateralsTheFileDoesNotMakeAreRefused) {
  GmshParameters p = written("deaf.geo", "DefineConstant[ recombine = 0 ];\n" + square + "Plane Surface(1) = {1};");
  p.cells = CellType::quadrilateral;
  TEST_ASSERT(holds(refusal(p), "cannot be had: the mesh of"));
}

TEUCHOS_UNIT_TEST(Gmsh, AFinishedMeshTakesNoNumbers) {
  GmshParameters p = written("finished.msh", "$MeshFormat\n");
  p.element_size = 0.1;
  TEST_ASSERT(holds(refusal(p), "is a finished mesh"));
}

}  // namespace
