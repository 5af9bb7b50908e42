// What must hold for every source of blocks, however it was made, found by looking at all vertices.
#pragma once

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "mesh/mesh.hpp"
#include "support/input_error.hpp"

namespace voussoir::test {

/// Equal vertices <=> bitwise equal positions; the graph counts exactly the vertices two blocks share;
/// numbers are compact; cells turn counter-clockwise.
inline void check_source(const BlockSource<2>& source, Teuchos::FancyOStream& out, bool& success) {
  std::map<VertexId, Vector<2>> position;
  std::set<Vector<2>> places;
  std::vector<std::set<VertexId>> vertices;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const Block<2> block = source.block(b);
    TEST_EQUALITY(block.id, b);
    TEST_EQUALITY(int(block.position.size()), source.node_count(b));
    TEST_EQUALITY(block.vertex.size(), block.position.size());
    vertices.emplace_back(block.vertex.begin(), block.vertex.end());
    TEST_EQUALITY(vertices.back().size(), block.vertex.size());
    for (std::size_t n = 0; n < block.vertex.size(); ++n) {
      const auto known = position.emplace(block.vertex[n], block.position[n]).first;
      TEST_ASSERT(known->second == block.position[n]);
      places.insert(block.position[n]);
    }
    for (const Cell& cell : block.cells)
      for (int k = 0; k < cell.count; ++k) {
        const auto corner = [&](int i) { return block.position[cell.node[(k + i) % cell.count]]; };
        TEST_ASSERT(cross(corner(1) - corner(0), corner(2) - corner(1)) > 0);
      }
    for (const int set : block.sets) TEST_ASSERT(set >= 0 && set < int(source.block_sets().size()));
    for (const TaggedFacet& facet : block.facets)
      TEST_ASSERT(facet.count == 2 && facet.set >= 0 && facet.set < int(source.facet_sets().size()));
  }
  TEST_EQUALITY(places.size(), position.size());

  const BlockGraph graph = graph_of(source);
  TEST_EQUALITY(int(graph.start.size()), source.block_count() + 1);
  std::size_t entry = 0;
  for (BlockId a = 0; a < source.block_count(); ++a) {
    for (BlockId b = 0; b < source.block_count(); ++b) {
      std::vector<VertexId> shared;
      std::set_intersection(vertices[a].begin(), vertices[a].end(), vertices[b].begin(), vertices[b].end(),
                            std::back_inserter(shared));
      if (a == b || shared.empty()) continue;
      TEST_ASSERT(entry < graph.neighbour.size() && graph.neighbour[entry] == b &&
                  graph.shared_vertices[entry] == int(shared.size()));
      ++entry;
    }
    TEST_EQUALITY(int(entry), graph.start[a + 1]);
  }
}

/// Positions of all facets of a set: midpoints, for all blocks.
inline std::vector<Vector<2>> facet_midpoints(const BlockSource<2>& source, const std::string& set) {
  std::vector<Vector<2>> midpoints;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const Block<2> block = source.block(b);
    for (const TaggedFacet& f : block.facets)
      if (source.facet_sets()[f.set] == set)
        midpoints.push_back(0.5 * (block.position[f.node[0]] + block.position[f.node[1]]));
  }
  return midpoints;
}

}  // namespace voussoir::test
