#include "joints/joint_finder_in_space.hpp"

#include <algorithm>
#include <cmath>

#include "joints/same_side.hpp"

namespace voussoir {
namespace {

/// Of the corners of a face: integral of the shape function times the outward normal [m2], by 2 x 2 Gauss points.
std::array<Vector<3>, 4> shares_of_corners(const std::array<Vector<3>, 4>& x) {
  constexpr std::array<Vector<2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const double g = 1 / std::sqrt(3.0);
  std::array<Vector<3>, 4> share{};
  for (const auto& at : corners) {
    std::array<double, 4> value;
    Vector<3> along{}, up{};
    for (int i = 0; i < 4; ++i) {
      const double s = 1 + g * at[0] * corners[i][0], t = 1 + g * at[1] * corners[i][1];
      value[i] = s * t / 4;
      along = along + (corners[i][0] * t / 4) * x[i];
      up = up + (corners[i][1] * s / 4) * x[i];
    }
    for (int i = 0; i < 4; ++i) share[i] = share[i] + value[i] * cross(along, up);
  }
  return share;
}

/// Adds a corner of a face to the point it belongs to.
void add_corner(std::vector<PointInSpace>& points, VertexId vertex, int node_i, int node_j, const Vector<3>& normal) {
  for (auto& p : points)
    if (p.vertex == vertex && on_same_side(p.normal, normal)) {
      p.normal = p.normal + normal;
      p.area += norm(normal);
      return;
    }
  points.push_back({vertex, node_i, node_j, normal, norm(normal)});
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
      add_corner(points, vertex, a.node[k], *other, share[k]);
    }
  }
  for (auto& p : points) p.normal = (1 / norm(p.normal)) * p.normal;
  std::stable_sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.vertex < q.vertex; });
  return points;
}

}  // namespace voussoir
