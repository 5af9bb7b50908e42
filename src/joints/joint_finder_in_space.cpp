#include "joints/joint_finder_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "joints/same_side.hpp"
#include "mesh/face_shares.hpp"

namespace voussoir {
namespace {

/// Points as they are found, and the part of the joint that each belongs to.
class PointsOfParts {
 public:
  /// Adds a corner of a face to the point it belongs to.
  void add_corner(const PointInSpace& corner, int part) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      auto& p = points[k];
      if (p.vertex != corner.vertex || part_[k] != part || !on_same_side(p.normal, corner.normal)) continue;
      p.normal = p.normal + corner.normal;
      p.area += corner.area;
      return;
    }
    points.push_back(corner);
    part_.push_back(part);
  }
  std::vector<PointInSpace> points;

 private:
  std::vector<int> part_;
};

using PartOfFace = std::map<std::array<VertexId, BorderFace::corners>, int>;

/// Of faces of bent joints, by their vertices as border_faces() has them.
PartOfFace parts_of(const Block<3>& block) {
  PartOfFace parts;
  for (const auto& facet : block.facets) {
    if (facet.set >= 0) continue;
    std::array<VertexId, BorderFace::corners> vertices;
    for (int k = 0; k < BorderFace::corners; ++k) vertices[k] = block.vertex[facet.node[k]];
    if (facet.count == 3) vertices[3] = std::max({vertices[0], vertices[1], vertices[2]});
    std::sort(vertices.begin(), vertices.end());
    parts[vertices] = -1 - facet.set;
  }
  return parts;
}

}  // namespace

std::vector<PointInSpace> points_of_joint(const Block<3>& i, const std::vector<BorderFace>& border_i, const Block<3>& j,
                                          const std::vector<BorderFace>& border_j) {
  PointsOfParts found;
  const auto parts = parts_of(i);
  auto b = border_j.begin();
  for (const auto& a : border_i) {
    while (b != border_j.end() && b->vertices < a.vertices) ++b;
    if (b == border_j.end()) break;
    if (b->vertices != a.vertices) continue;
    std::array<Vector<3>, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = i.position[a.node[k]];
    const auto share = shares_of_corners(x);
    const auto part = parts.find(a.vertices);
    for (int k = 0; k < 4; ++k) {
      const VertexId vertex = i.vertex[a.node[k]];
      const auto other = std::find_if(b->node.begin(), b->node.end(), [&](int n) { return j.vertex[n] == vertex; });
      found.add_corner({vertex, a.node[k], *other, share[k], norm(share[k])}, part == parts.end() ? -1 : part->second);
    }
  }
  auto points = std::move(found.points);
  for (auto& p : points) p.normal = (1 / norm(p.normal)) * p.normal;
  std::stable_sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.vertex < q.vertex; });
  return points;
}

}  // namespace voussoir
