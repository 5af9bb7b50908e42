#include "mesh/border.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace voussoir {
namespace {

/// Nodes of the facets of a cell, each as BorderFacet has them.
std::vector<std::array<int, 2>> facets_of(const Cell& cell, const Block<2>&) {
  std::vector<std::array<int, 2>> edges;
  for (int k = 0; k < cell.count; ++k) edges.push_back({cell.node[k], cell.node[(k + 1) % cell.count]});
  return edges;
}

/// Triangles have the node of their largest vertex twice: which it is, both sides of a joint agree on.
std::vector<std::array<int, 4>> triangles_of(const Cell& cell, const Block<3>& block) {
  std::vector<std::array<int, 4>> nodes;
  for (const auto& f : std::array<std::array<int, 3>, 4>{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}) {
    std::array<int, 3> n{cell.node[f[0]], cell.node[f[1]], cell.node[f[2]]};
    const auto last =
        std::max_element(n.begin(), n.end(), [&](int a, int b) { return block.vertex[a] < block.vertex[b]; });
    std::rotate(n.begin(), last + 1, n.end());
    nodes.push_back({n[0], n[1], n[2], n[2]});
  }
  return nodes;
}

std::vector<std::array<int, 4>> facets_of(const Cell& cell, const Block<3>& block) {
  if (cell.count == 4) return triangles_of(cell, block);
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  VOUSSOIR_EXPECT(cell.count == 8);
  std::vector<std::array<int, 4>> nodes;
  for (const auto& f : faces) nodes.push_back({cell.node[f[0]], cell.node[f[1]], cell.node[f[2]], cell.node[f[3]]});
  return nodes;
}

}  // namespace

std::array<VertexId, 2> ascending(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

template <int dim>
std::vector<BorderFacet<dim>> border_facets(const std::vector<Block<dim>>& blocks) {
  std::vector<BorderFacet<dim>> border, facets;
  for (const Block<dim>& block : blocks) {
    facets.clear();
    for (const Cell& cell : block.cells)
      for (const auto& node : facets_of(cell, block)) {
        BorderFacet<dim> facet{{}, block.id, node};
        for (std::size_t k = 0; k < node.size(); ++k) facet.vertices[k] = block.vertex[node[k]];
        std::sort(facet.vertices.begin(), facet.vertices.end());
        facets.push_back(facet);
      }
    std::sort(facets.begin(), facets.end());
    for (std::size_t from = 0, to = 0; from < facets.size(); from = to) {
      while (to < facets.size() && !(facets[from] < facets[to])) ++to;
      if (to == from + 1) border.push_back(facets[from]);
    }
  }
  std::sort(border.begin(), border.end());
  return border;
}

template std::vector<BorderEdge> border_facets(const std::vector<Block<2>>&);
template std::vector<BorderFace> border_facets(const std::vector<Block<3>>&);

}  // namespace voussoir
