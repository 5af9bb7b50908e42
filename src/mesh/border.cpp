#include "mesh/border.hpp"

#include <algorithm>

namespace voussoir {

std::array<VertexId, 2> ascending(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<BorderEdge> border_edges(const std::vector<Block<2>>& blocks) {
  std::vector<BorderEdge> border, edges;
  for (const Block<2>& block : blocks) {
    edges.clear();
    for (const Cell& cell : block.cells)
      for (int k = 0; k < cell.count; ++k) {
        const int a = cell.node[k], b = cell.node[(k + 1) % cell.count];
        edges.push_back({ascending(block.vertex[a], block.vertex[b]), block.id, {a, b}});
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t from = 0, to = 0; from < edges.size(); from = to) {
      while (to < edges.size() && !(edges[from] < edges[to])) ++to;
      if (to == from + 1) border.push_back(edges[from]);
    }
  }
  std::sort(border.begin(), border.end());
  return border;
}

}  // namespace voussoir
