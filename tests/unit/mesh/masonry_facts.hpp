// What must hold for every source of blocks in space, found by looking at all vertices; sums over blocks and facets.
#pragma once

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/face_shares.hpp"
#include "mesh/mesh.hpp"

namespace voussoir::test {

/// The corners of the faces of a hexahedron, counter-clockwise seen from outside.
inline constexpr int faces_of_hexahedron[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// Area with its direction [m2], and a third of the integral of x . n [m3], of a bilinear face.
struct FaceSums {
  Vector<3> area{};
  double volume = 0;
  void add(const std::array<Vector<3>, 4>& x) {
    const auto share = shares_of_corners(x);
    for (int i = 0; i < 4; ++i) {
      area = area + share[i];
      volume += dot(x[i], share[i]) / 3;
    }
  }
};

inline double volume(const Block<3>& block, const Cell& cell) {
  FaceSums sums;
  for (const auto& face : faces_of_hexahedron) {
    std::array<Vector<3>, 4> x;
    for (int i = 0; i < 4; ++i) x[i] = block.position[cell.node[face[i]]];
    sums.add(x);
  }
  return sums.volume;
}

/// The three edges that leave a corner turn right-handed at every corner of a cell.
inline bool turns_right(const Block<3>& block, const Cell& cell) {
  for (int k = 0; k < 8; ++k) {
    const int level = k / 4 * 4, next = level + (k + 1) % 4, last = level + (k + 3) % 4, across = (k + 4) % 8;
    const auto edge = [&](int to) { return block.position[cell.node[to]] - block.position[cell.node[k]]; };
    if (!((level == 0 ? 1 : -1) * dot(edge(across), cross(edge(next), edge(last))) > 0)) return false;
  }
  return true;
}

inline double volume(const BlockSource<3>& source) {
  double all = 0;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    for (const auto& cell : block.cells) all += volume(block, cell);
  }
  return all;
}

/// Over the facets of some sets.
inline FaceSums sums_over(const BlockSource<3>& source, const std::set<std::string>& names) {
  FaceSums sums;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    for (const auto& facet : block.facets) {
      if (names.count(source.facet_sets()[facet.set]) == 0) continue;
      std::array<Vector<3>, 4> x;
      for (int i = 0; i < 4; ++i) x[i] = block.position[facet.node[i]];
      sums.add(x);
    }
  }
  return sums;
}

/// Names of the blocks of a set.
inline std::vector<std::string> blocks_of(const BlockSource<3>& source, const std::string& set) {
  std::vector<std::string> names;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    for (const int s : block.sets)
      if (source.block_sets()[s] == set) names.push_back(block.name);
  }
  return names;
}

/// Pairs of blocks that share the corners of faces of cells.
inline int joints(const BlockSource<3>& source) {
  std::map<std::set<VertexId>, BlockId> first;
  std::set<std::pair<BlockId, BlockId>> pairs;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    std::map<std::set<VertexId>, int> times;
    for (const auto& cell : block.cells)
      for (const auto& face : faces_of_hexahedron) {
        std::set<VertexId> corners;
        for (const int k : face) corners.insert(block.vertex[cell.node[k]]);
        ++times[corners];
      }
    for (const auto& [corners, count] : times) {
      if (count != 1) continue;
      const auto known = first.emplace(corners, b);
      if (!known.second) pairs.emplace(known.first->second, b);
    }
  }
  return static_cast<int>(pairs.size());
}

/// Equal vertices <=> bitwise equal places; the graph counts exactly the vertices two blocks share; no cell is turned
/// inside out.
inline void check_source(const BlockSource<3>& source, Teuchos::FancyOStream& out, bool& success) {
  std::map<VertexId, Vector<3>> place;
  std::set<Vector<3>> places;
  std::vector<std::set<VertexId>> vertices;
  for (BlockId b = 0; b < source.block_count(); ++b) {
    const auto block = source.block(b);
    TEST_EQUALITY(block.id, b);
    TEST_EQUALITY(int(block.position.size()), source.node_count(b));
    vertices.emplace_back(block.vertex.begin(), block.vertex.end());
    TEST_EQUALITY(vertices.back().size(), block.position.size());
    for (std::size_t n = 0; n < block.vertex.size(); ++n) {
      TEST_ASSERT(place.emplace(block.vertex[n], block.position[n]).first->second == block.position[n]);
      places.insert(block.position[n]);
    }
    for (const auto& cell : block.cells) TEST_ASSERT(cell.count == 8 && turns_right(block, cell));
    TEST_ASSERT(std::is_sorted(block.sets.begin(), block.sets.end()));
    for (const int set : block.sets) TEST_ASSERT(set >= 0 && set < int(source.block_sets().size()));
    for (const auto& facet : block.facets)
      TEST_ASSERT(facet.count == 4 && facet.set >= 0 && facet.set < int(source.facet_sets().size()));
  }
  TEST_EQUALITY(places.size(), place.size());
  const auto graph = graph_of(source);
  std::size_t entry = 0;
  for (BlockId a = 0; a < source.block_count(); ++a) {
    for (BlockId b = 0; b < source.block_count(); ++b) {
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

}  // namespace voussoir::test
