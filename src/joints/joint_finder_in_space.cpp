#include "joints/joint_finder_in_space.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/face_shares.hpp"
#include "mesh/same_side.hpp"

namespace voussoir {
namespace {

/// Adds a corner of a face to the point it belongs to.
void add_corner(std::vector<PointInSpace>& points, const PointInSpace& corner, bool fold) {
  for (auto& p : points)
    if (p.vertex == corner.vertex && on_same_side(p.normal, corner.normal, fold)) {
      p.normal = p.normal + corner.normal;
      p.area += corner.area;
      return;
    }
  points.push_back(corner);
}

}  // namespace

std::vector<PointInSpace> points_of_joint(const Block<3>& i, const std::vector<BorderFace>& border_i, const Block<3>& j,
                                          const std::vector<BorderFace>& border_j) {
  std::vector<PointInSpace> points;
  auto b = border_j.begin();
  for (const auto& a : border_i) {
    while (b != border_j.end() && b->vertices < a.vertices) ++b;
    if (b == border_j.end()) break;
    if (b->vertices != a.vertices) continue;
    std::array<Vector<3>, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = i.position[a.node[k]];
    const auto share = shares_of_corners(x);
    for (int k = 0; k < 4; ++k) {
      const VertexId vertex = i.vertex[a.node[k]];
      const auto other = std::find_if(b->node.begin(), b->node.end(), [&](int n) { return j.vertex[n] == vertex; });
      add_corner(points, {vertex, a.node[k], *other, share[k], norm(share[k])},
                 is_fold(i, a.node[k]) || is_fold(j, *other));
    }
  }
  for (auto& p : points) p.normal = (1 / norm(p.normal)) * p.normal;
  std::stable_sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.vertex < q.vertex; });
  return points;
}

}  // namespace voussoir
