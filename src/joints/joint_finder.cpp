#include "joints/joint_finder.hpp"

#include <algorithm>

#include "mesh/same_side.hpp"

namespace voussoir {

namespace {

/// Adds half an edge to the point it belongs to.
void add_half_edge(std::vector<PointOfTwoBlocks>& points, VertexId vertex, int node_i, int node_j,
                   const Vector<2>& normal, bool fold) {
  for (auto& p : points)
    if (p.vertex == vertex && on_same_side(p.normal, normal, fold)) {
      p.normal = p.normal + normal;
      p.length += norm(normal) / 2;
      return;
    }
  points.push_back({vertex, node_i, node_j, normal, norm(normal) / 2});
}

}  // namespace

std::vector<PointOfTwoBlocks> points_of_joint(const Block<2>& i, const std::vector<BorderEdge>& border_i,
                                              const Block<2>& j, const std::vector<BorderEdge>& border_j) {
  std::vector<PointOfTwoBlocks> points;
  auto b = border_j.begin();
  for (const auto& a : border_i) {
    while (b != border_j.end() && b->vertices < a.vertices) ++b;
    if (b == border_j.end()) break;
    if (b->vertices != a.vertices) continue;
    const auto along = i.position[a.node[1]] - i.position[a.node[0]];
    const Vector<2> normal{along[1], -along[0]};  // the block lies to the left of its border
    for (int node_i : a.node) {
      const int node_j = j.vertex[b->node[0]] == i.vertex[node_i] ? b->node[0] : b->node[1];
      add_half_edge(points, i.vertex[node_i], node_i, node_j, normal, is_fold(i, node_i) || is_fold(j, node_j));
    }
  }
  for (auto& p : points) p.normal = (1 / norm(p.normal)) * p.normal;
  std::stable_sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.vertex < q.vertex; });
  return points;
}

}  // namespace voussoir
