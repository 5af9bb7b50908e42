#include "joints/joint_finder.hpp"

#include <algorithm>
#include <utility>

namespace voussoir {

std::vector<BorderEdge> border_edges(const Block<2>& block) {
  struct Edge {
    BorderEdge border;
    bool operator<(const Edge& other) const {
      return std::make_pair(border.low, border.high) < std::make_pair(other.border.low, other.border.high);
    }
  };
  std::vector<Edge> edges;
  for (const auto& cell : block.cells)
    for (int k = 0; k < cell.count; ++k) {
      const int a = cell.node[k], b = cell.node[(k + 1) % cell.count];
      const auto along = block.position[b] - block.position[a];
      Edge e;
      e.border = {block.vertex[a], block.vertex[b], a, b, {along[1], -along[0]}};  // cells turn counter-clockwise
      if (e.border.low > e.border.high) {
        std::swap(e.border.low, e.border.high);
        std::swap(e.border.node_low, e.border.node_high);
      }
      edges.push_back(e);
    }
  std::sort(edges.begin(), edges.end());
  std::vector<BorderEdge> border;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const bool twice = (k > 0 && !(edges[k - 1] < edges[k])) || (k + 1 < edges.size() && !(edges[k] < edges[k + 1]));
    if (!twice) border.push_back(edges[k].border);
  }
  return border;
}

namespace {

/// Adds half an edge to the point it belongs to.
void add_half_edge(std::vector<PointOfTwoBlocks>& points, VertexId vertex, int node_i, int node_j,
                   const Vector<2>& normal) {
  constexpr double same_side = 0.94;  // cosine of 20 degrees
  for (auto& p : points)
    if (p.vertex == vertex && dot(p.normal, normal) > same_side * norm(p.normal) * norm(normal)) {
      p.normal = p.normal + normal;
      p.length += norm(normal) / 2;
      return;
    }
  points.push_back({vertex, node_i, node_j, normal, norm(normal) / 2});
}

}  // namespace

std::vector<PointOfTwoBlocks> points_of_joint(const std::vector<BorderEdge>& i, const std::vector<BorderEdge>& j) {
  std::vector<PointOfTwoBlocks> points;
  auto b = j.begin();
  for (const auto& a : i) {
    const auto key = std::make_pair(a.low, a.high);
    while (b != j.end() && std::make_pair(b->low, b->high) < key) ++b;
    if (b == j.end()) break;
    if (std::make_pair(b->low, b->high) != key) continue;
    add_half_edge(points, a.low, a.node_low, b->node_low, a.normal);
    add_half_edge(points, a.high, a.node_high, b->node_high, a.normal);
  }
  for (auto& p : points) p.normal = (1 / norm(p.normal)) * p.normal;
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& c) { return a.vertex < c.vertex; });
  return points;
}

}  // namespace voussoir
