// Walls and arches: numbers and positions of the reference scenes, matching nodes, sets, refusals.
#include "mesh/generators.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "support/repository.hpp"
#include "unit/mesh/mesh_facts.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Largest distance [m] between the nodes of a source and those of a table "block,x_m,y_m", which lists the nodes of a
/// block in lattice order; infinite when a block has another number of nodes.
double distance_to_reference(const BlockSource<2>& source, const std::string& name) {
  std::ifstream file(repository("/tests/unit/mesh/reference/") + name);
  std::map<int, std::vector<Vector<2>>> table;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream row(line);
    int block = 0;
    char comma = 0;
    Vector<2> x{};
    row >> block >> comma >> x[0] >> comma >> x[1];
    table[block].push_back(x);
  }
  if (int(table.size()) != source.block_count()) return INFINITY;
  double largest = 0;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const Block<2> block = source.block(b);
    if (block.position.size() != table[b].size()) return INFINITY;
    for (std::size_t n = 0; n < table[b].size(); ++n)
      largest = std::max(largest, norm(block.position[n] - table[b][n]));
  }
  return largest;
}

WallParameters wall(int courses, int blocks) {
  WallParameters p;
  p.courses = courses;
  p.blocks_per_course = blocks;
  return p;
}

TEUCHOS_UNIT_TEST(Wall, BlocksAndNodesAreThoseOfTheReferenceScene) {
  // All coordinates are multiples of 1/8 m and exact in the table.
  TEST_EQUALITY(distance_to_reference(*make_wall(wall(4, 4)), "W4_nodes.csv"), 0.0);
}

TEUCHOS_UNIT_TEST(Arch, BlocksAndNodesAreThoseOfTheReferenceScene) {
  // The table has nine digits of coordinates below 10 m: half a unit of the last is 5e-9 m.
  TEST_COMPARE(distance_to_reference(*make_arch({}), "A31_nodes.csv"), <=, 5e-9 * std::sqrt(2.0));
}

TEUCHOS_UNIT_TEST(Wall, CoincidentNodesShareVerticesAndTheGraphCountsThem) {
  WallParameters p = wall(5, 3);
  p.block_length = 0.7;  // thirds and sevenths: positions that round
  p.block_height = 1.0 / 3;
  p.cells_along = 6;
  p.cells_up = 3;
  check_source(*make_wall(p), out, success);
  p.cells = CellType::triangle;
  check_source(*make_wall(p), out, success);
  p.openings["door"] = {0.5, 1.5, -1, 0.9};
  check_source(*make_wall(p), out, success);
}

TEUCHOS_UNIT_TEST(Wall, OneBlockIsAWall) {
  const auto source = make_wall(wall(1, 1));
  check_source(*source, out, success);
  for (const char* side : {"base", "top", "left", "right"}) TEST_ASSERT(!facet_midpoints(*source, side).empty());
}

TEUCHOS_UNIT_TEST(Wall, FacetSetsAreTheFourSides) {
  const auto source = make_wall(wall(4, 4));  // 2 m x 1 m; cells 1/8 m
  for (const auto& [side, axis, value, count] :
       {std::tuple("base", 1, 0.0, 16), {"top", 1, 1.0, 16}, {"left", 0, 0.0, 8}, {"right", 0, 2.0, 8}}) {
    const auto midpoints = facet_midpoints(*source, side);
    TEST_EQUALITY(int(midpoints.size()), count);
    for (const Vector<2>& x : midpoints) TEST_EQUALITY(x[axis], value);
  }
}

TEUCHOS_UNIT_TEST(Wall, OpeningsLeaveOutBlocksWithTheirCentreInsideAndKeepNumbersCompact) {
  WallParameters p = wall(4, 4);
  p.openings["window"] = {0.5, 1.5, 0.25, 0.75};  // course 1: centres 0.5, 1.0, 1.5; course 2: centres 0.75, 1.25
  const auto source = make_wall(p);
  TEST_EQUALITY(source->block_count(), 18 - 3);  // a centre on the border of the opening is not inside
  TEST_EQUALITY(source->block(5).name, "block 5 (course 1, stone 1)");
  TEST_EQUALITY(source->block(6).name, "block 6 (course 1, stone 3)");
  check_source(*source, out, success);
}

TEUCHOS_UNIT_TEST(Wall, EveryBlockIsInTheSetOfItsCourse) {
  const auto source = make_wall(wall(3, 2));
  TEST_EQUALITY(source->block_sets().size(), 3u);
  TEST_EQUALITY(source->block_sets()[2], "course 2");
  const int course[] = {0, 0, 1, 1, 1, 2, 2};
  for (BlockId b = 0; b < 7; ++b) TEST_ASSERT(source->block(b).sets == std::vector<int>{course[b]});
}

TEUCHOS_UNIT_TEST(Wall, AMillionBlocksAreCountedWithoutBuildingThem) {
  const auto source = make_wall(wall(1000, 1000));
  TEST_EQUALITY(source->block_count(), 1000500);
  TEST_EQUALITY(source->block(1000499).name, "block 1000499 (course 999, stone 1000)");
  const auto graph = graph_of(*source);
  TEST_EQUALITY(graph.start.size(), 1000501u);
  // n blocks and n + 1 blocks in turn: 500 (n - 1) + 500 n head joints, and 2 n bed joints between any two courses,
  // each seen from both sides.
  TEST_EQUALITY(graph.neighbour.size(), 2u * (500 * 999 + 500 * 1000 + 999 * 2000));
}

TEUCHOS_UNIT_TEST(Arch, CoincidentNodesShareVerticesAndTheGraphCountsThem) {
  ArchParameters p;
  p.voussoirs = 7;
  check_source(*make_arch(p), out, success);
  p.embrace = 157.5;
  p.cells = CellType::triangle;
  check_source(*make_arch(p), out, success);
  p.embrace = 180;
  p.pier_height = 3.1;
  check_source(*make_arch(p), out, success);
  p.voussoirs = 1;
  p.cells_along = 8;
  p.pier_courses = 1;
  check_source(*make_arch(p), out, success);
}

TEUCHOS_UNIT_TEST(Arch, IsItsOwnMirrorImageBitByBit) {
  ArchParameters p;
  p.voussoirs = 8;
  p.pier_height = 2;
  const auto source = make_arch(p);
  std::set<Vector<2>> all, mirrored;
  for (BlockId b = 0; b < source->block_count(); ++b)
    for (const Vector<2>& x : source->block(b).position) {
      all.insert(x);
      mirrored.insert({-x[0], x[1]});
    }
  TEST_ASSERT(all == mirrored);
}

TEUCHOS_UNIT_TEST(Arch, SpringingsAreLevelAndItsFacesLieOnTheirCircles) {
  const auto source = make_arch({});
  for (const char* side : {"springing left", "springing right"}) {
    const auto midpoints = facet_midpoints(*source, side);
    TEST_EQUALITY(midpoints.size(), 4u);
    for (const Vector<2>& x : midpoints) {
      TEST_EQUALITY(x[1], 0.0);
      TEST_EQUALITY(x[0] > 0, side == std::string("springing right"));
    }
  }
  // Midpoints of chords lie r (1 - cos(90 / 62 degrees)) = 3.2e-4 r inside the circle.
  for (const Vector<2>& x : facet_midpoints(*source, "extrados")) TEST_FLOATING_EQUALITY(norm(x), 5.5, 3.3e-4);
  for (const Vector<2>& x : facet_midpoints(*source, "intrados")) TEST_FLOATING_EQUALITY(norm(x), 4.5, 3.3e-4);
  TEST_EQUALITY(facet_midpoints(*source, "extrados").size(), 62u);
  TEST_ASSERT((source->block_sets() == SetNames{"ring"}));
}

TEUCHOS_UNIT_TEST(Arch, PiersStandBelowTheSpringingsAndCarryTheirFacetSets) {
  ArchParameters p;
  p.pier_height = 4;
  p.pier_courses = 2;  // blocks 1 m wide and 2 m high, cells of 0.25 m
  const auto source = make_arch(p);
  TEST_EQUALITY(source->block_count(), 31 + 4);
  TEST_EQUALITY(source->node_count(31), 5 * 9);
  for (const char* side : {"springing left", "springing right"})
    for (const Vector<2>& x : facet_midpoints(*source, side)) TEST_EQUALITY(x[1], -4.0);
  TEST_EQUALITY(source->block(31).name, "block 31 (pier right, course 0)");
  TEST_EQUALITY(source->block_sets()[source->block(34).sets[0]], "pier left");
  TEST_ASSERT((source->block(34).position.back() == Vector<2>{-4.5, 0.0}));
}

TEUCHOS_UNIT_TEST(Generators, RefuseParametersThatDescribeNothing) {
  const auto wall_error = [](auto change) {
    WallParameters p;
    change(p);
    return input_error([&] { make_wall(p); });
  };
  const auto arch_error = [](auto change) {
    ArchParameters p;
    change(p);
    return input_error([&] { make_arch(p); });
  };
  TEST_EQUALITY(wall_error([](WallParameters&) {}), "");
  TEST_ASSERT(holds(wall_error([](auto& p) { p.courses = 0; }), "wall > courses = 0 [-]"));
  TEST_ASSERT(holds(wall_error([](auto& p) { p.block_length = NAN; }), "wall > block length = nan [m]"));
  TEST_ASSERT(holds(wall_error([](auto& p) { p.cells_along = 5; }), "cells along = 5 [-]\n  must be even"));
  TEST_ASSERT(holds(wall_error([](auto& p) { p.courses = p.blocks_per_course = 100000; }), "makes about 1e+10 blocks"));
  TEST_ASSERT(holds(wall_error([](auto& p) { p.openings["door"] = {1, 0, 0, 1}; }), "openings > door = 1 .. 0"));
  TEST_ASSERT(holds(wall_error([](auto& p) { p.openings["all"] = {-1, 9, -1, 9}; }), "leave no block"));
  TEST_ASSERT(
      holds(arch_error([](auto& p) { p.thickness = 10; }), "thickness = 10 [m]\n  must be < 2 x radius = 10 m"));
  TEST_ASSERT(holds(arch_error([](auto& p) { p.embrace = 360; }), "embrace = 360 [degree]"));
  TEST_ASSERT(holds(arch_error([](auto& p) { p.voussoirs = 1; }), "makes cells of 90 degrees"));
  TEST_ASSERT(holds(arch_error([](auto& p) { p.pier_height = -1; }), "pier height = -1 [m]"));
  TEST_ASSERT(
      holds(arch_error([](auto& p) { p.pier_height = 1, p.embrace = 120; }), "needs an embrace of 180 degrees"));
}

}  // namespace
