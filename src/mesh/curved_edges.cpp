#include "mesh/curved_edges.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/sort_unique.hpp"
#include "mesh/border.hpp"

namespace voussoir {
namespace {

using Edge = std::array<int, 2>;

Edge edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// All pairs of nodes of the cells with so many of them: of tetrahedra their edges; of hexahedra diagonals too, which a
/// tetrahedron beside may have as its edge.
std::vector<Edge> pairs_of(const Block<3>& block, int count) {
  std::vector<Edge> pairs;
  for (const auto& cell : block.cells) {
    if (cell.count != count) continue;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < i; ++j) pairs.push_back(edge(cell.node[i], cell.node[j]));
  }
  sort_unique(pairs);
  return pairs;
}

std::vector<Edge> without(const std::vector<Edge>& all, const std::vector<Edge>& some) {
  std::vector<Edge> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

/// An edge of a block by its vertices, so that blocks that touch have the same.
struct PlacedEdge {
  std::array<VertexId, 2> vertices;
  BlockId block;
  Edge nodes;
  bool operator<(const PlacedEdge& other) const {
    return std::tie(vertices, block, nodes) < std::tie(other.vertices, other.block, other.nodes);
  }
};

}  // namespace

void find_curved_edges(std::vector<Block<3>>& blocks) {
  std::vector<PlacedEdge> edges;
  for (auto& block : blocks) {
    const auto of_hexahedra = pairs_of(block, 8);
    block.curved = without(pairs_of(block, 4), of_hexahedra);
    auto all = of_hexahedra;
    all.insert(all.end(), block.curved.begin(), block.curved.end());
    for (const auto& e : all) edges.push_back({ascending(block.vertex[e[0]], block.vertex[e[1]]), block.id, e});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::vector<Edge>> shared(blocks.size());
  for (auto from = edges.begin(), to = from; from != edges.end(); from = to) {
    while (to != edges.end() && to->vertices == from->vertices) ++to;
    if (std::prev(to)->block != from->block)
      for (auto e = from; e != to; ++e) shared[e->block].push_back(e->nodes);
  }
  for (auto& block : blocks) {
    auto& straight = shared[block.id];
    std::sort(straight.begin(), straight.end());
    block.curved = without(block.curved, straight);
  }
}

std::vector<std::array<int, 2>> curved_edges_off(const Block<3>& block,
                                                 const std::function<bool(const TaggedFacet&)>& straightens) {
  if (block.curved.empty()) return {};
  std::vector<Edge> straight;
  for (const auto& facet : block.facets) {
    if (!straightens(facet)) continue;
    for (int i = 0; i < facet.count; ++i)
      for (int j = 0; j < i; ++j) straight.push_back(edge(facet.node[i], facet.node[j]));
  }
  sort_unique(straight);
  return without(block.curved, straight);
}

}  // namespace voussoir
