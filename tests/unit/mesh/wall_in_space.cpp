// Walls in space: matching nodes, the graph, sets and their faces, the ground, refusals.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <map>
#include <set>

#include "mesh/face_shares.hpp"
#include "mesh/generators.hpp"
#include "unit/mesh/mesh_facts.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

WallInSpaceParameters wall(int courses, int blocks) {
  WallInSpaceParameters p;
  p.courses = courses;
  p.blocks_per_course = blocks;
  p.block_length = 0.7;  // thirds and sevenths: positions that round
  p.block_height = 1.0 / 3;
  p.thickness = 0.3;
  return p;
}

/// Volume of a cell by its six faces, and whether none of its corners is turned inside out.
double volume(const Block<3>& block, const Cell& cell) {
  const auto& n = cell.node;
  const auto edge = [&](int a, int b) { return block.position[n[b]] - block.position[n[a]]; };
  return dot(edge(0, 4), cross(edge(0, 1), edge(0, 3)));
}

/// What two blocks share, from all vertices, against the graph; vertices against places; volumes against the box.
void check(const WallInSpaceParameters& p, Teuchos::FancyOStream& out, bool& success) {
  const auto source = make_wall_in_space(p);
  std::map<VertexId, Vector<3>> place;
  std::set<Vector<3>> places;
  std::vector<std::set<VertexId>> vertices;
  double whole = 0;
  for (BlockId b = 0; b < source->block_count(); ++b) {
    const auto block = source->block(b);
    TEST_EQUALITY(block.id, b);
    TEST_EQUALITY(int(block.position.size()), source->node_count(b));
    vertices.emplace_back(block.vertex.begin(), block.vertex.end());
    TEST_EQUALITY(vertices.back().size(), block.position.size());
    for (std::size_t n = 0; n < block.vertex.size(); ++n) {
      TEST_ASSERT(place.emplace(block.vertex[n], block.position[n]).first->second == block.position[n]);
      places.insert(block.position[n]);
    }
    for (const auto& cell : block.cells) {
      TEST_ASSERT(cell.count == 8 && volume(block, cell) > 0);
      whole += volume(block, cell);
    }
  }
  TEST_EQUALITY(places.size(), place.size());
  TEST_FLOATING_EQUALITY(
      whole, p.blocks_per_course * p.block_length * p.thickness * (p.courses * p.block_height + p.ground_height),
      1e-13);
  const auto graph = graph_of(*source);
  std::size_t entry = 0;
  for (BlockId a = 0; a < source->block_count(); ++a) {
    for (BlockId b = 0; b < source->block_count(); ++b) {
      int shared = 0;
      for (const auto v : vertices[a]) shared += static_cast<int>(vertices[b].count(v));
      if (a == b || shared == 0) continue;
      TEST_ASSERT(entry < graph.neighbour.size() && graph.neighbour[entry] == b);
      TEST_EQUALITY(graph.shared_vertices[entry], shared);
      ++entry;
    }
    TEST_EQUALITY(int(entry), graph.start[a + 1]);
  }
}

TEUCHOS_UNIT_TEST(WallInSpace, CoincidentNodesShareVerticesAndTheGraphCountsThem) {
  auto p = wall(5, 3);
  p.cells_along = 4;
  p.cells_up = 1;
  p.cells_across = 3;
  check(p, out, success);
  p.ground_height = 0.2;
  check(p, out, success);
  p.bond = WallBond::stack;
  p.cells_along = 1;
  check(p, out, success);
  check(wall(1, 1), out, success);
}

/// Sum of the areas of a set [m2], each with its direction out of the block.
Vector<3> area(const BlockSource<3>& source, const std::string& name) {
  Vector<3> sum{};
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    for (const auto& facet : block.facets) {
      if (source.facet_sets()[facet.set] != name) continue;
      std::array<Vector<3>, 4> x;
      for (int i = 0; i < 4; ++i) x[i] = block.position[facet.node[i]];
      for (const auto& share : shares_of_corners(x)) sum = sum + share;
    }
  }
  return sum;
}

TEUCHOS_UNIT_TEST(WallInSpace, FacetSetsAreTheSixSidesAndLookOutward) {
  for (const double ground : {0.0, 0.25}) {
    auto p = wall(4, 3);
    p.ground_height = ground;
    const auto source = make_wall_in_space(p);
    const double length = 2.1, height = 4.0 / 3, thickness = 0.3;
    const std::map<std::string, Vector<3>> sides{
        {"base", {0, 0, -length * thickness}}, {"top", {0, 0, length * thickness}},
        {"left", {-height * thickness, 0, 0}}, {"right", {height * thickness, 0, 0}},
        {"front", {0, -length * height, 0}},   {"back", {0, length * height, 0}}};
    for (const auto& [name, expected] : sides) TEST_COMPARE(norm(area(*source, name) - expected), <=, 1e-14);
  }
}

// All nodes of the ground lie on its outer faces or below the wall, so that a support on them holds it whole.
TEUCHOS_UNIT_TEST(WallInSpace, TheGroundIsHeldWholeByItsSet) {
  auto p = wall(3, 2);
  p.ground_height = 0.5;
  const auto source = make_wall_in_space(p);
  TEST_EQUALITY(source->block(0).name, "block 0 (ground, stone 0)");
  TEST_EQUALITY(source->block_sets().number_of("ground"), int(source->block_sets().size()) - 1);
  for (const BlockId b : {0, 1}) {
    const auto block = source->block(b);
    TEST_ASSERT(block.sets == std::vector<int>{3});
    std::set<int> held;
    for (const auto& facet : block.facets)
      if (source->facet_sets()[facet.set] == "ground") held.insert(facet.node.begin(), facet.node.end());
    TEST_EQUALITY(held.size(), block.position.size());
    for (const auto& x : block.position) TEST_ASSERT(x[2] == 0 || x[2] == -0.5);
  }
  TEST_EQUALITY(make_wall_in_space(wall(3, 2))->facet_sets().size(), 6u);
}

TEUCHOS_UNIT_TEST(WallInSpace, BlocksAreNumberedByCoursesAndKnowThem) {
  const auto source = make_wall_in_space(wall(3, 2));
  const int course[] = {0, 0, 1, 1, 1, 2, 2};
  TEST_EQUALITY(source->block_count(), 7);
  for (BlockId b = 0; b < 7; ++b) TEST_ASSERT(source->block(b).sets == std::vector<int>{course[b]});
  TEST_EQUALITY(source->block(4).name, "block 4 (course 1, stone 2)");
}

TEUCHOS_UNIT_TEST(WallInSpace, WhatIsNoWallIsRefusedWithItsKey) {
  const auto said = [](const auto& change) {
    auto p = wall(2, 2);
    change(p);
    return input_error([&] { make_wall_in_space(p); });
  };
  TEST_ASSERT(holds(said([](auto& p) { p.cells_along = 3; }), "mesh > wall in space > cells along = 3 [-]"));
  TEST_ASSERT(said([](auto& p) {
                p.cells_along = 3;
                p.bond = WallBond::stack;
              }).empty());
  TEST_ASSERT(holds(said([](auto& p) { p.thickness = 0; }), "mesh > wall in space > thickness = 0 [m]"));
  TEST_ASSERT(holds(said([](auto& p) { p.courses = 1000000000; }), "more than numbers here can count"));
}

}  // namespace
