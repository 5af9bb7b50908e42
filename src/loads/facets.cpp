#include "loads/facets.hpp"

#include <algorithm>

#include "mesh/face_shares.hpp"

namespace voussoir {

template <int dim>
Bearers bearers_of(const Structure<dim>& s, const std::array<int, 4>& node) {
  Bearers bearers;
  bearers.node = node;
  for (int i = 0; i < 3; ++i)
    if (const int a = node[i], b = node[(i + 1) % 3]; a >= 0 && b >= 0) bearers.edge[i] = s.edge_between(a, b);
  return bearers;
}

template Bearers bearers_of(const Structure<2>&, const std::array<int, 4>&);
template Bearers bearers_of(const Structure<3>&, const std::array<int, 4>&);

std::vector<LoadedEdge> edges_of_set(const Structure<2>& s, const FacetSet& set) {
  std::vector<LoadedEdge> edges;
  for (const auto& b : s.blocks())
    for (const auto& f : b.mesh.facets) {
      if (!set.has(b.mesh, f)) continue;
      const auto& x0 = b.mesh.position[f.node[0]];
      const auto& x1 = b.mesh.position[f.node[1]];
      const auto along = x1 - x0;
      Vector<2> outward{along[1], -along[0]};
      for (const auto& cell : b.mesh.cells) {
        bool first = false, second = false;
        Vector<2> middle{};
        for (int i = 0; i < cell.count; ++i) {
          first |= cell.node[i] == f.node[0];
          second |= cell.node[i] == f.node[1];
          middle = middle + (1.0 / cell.count) * b.mesh.position[cell.node[i]];
        }
        if (first && second && dot(outward, middle - x0) > 0) outward = -1.0 * outward;
      }
      const double length = norm(along);
      edges.push_back({bearers_of(s, {b.first_local + f.node[0], b.first_local + f.node[1], -1, -1}),
                       {x0, x1},
                       (1 / length) * outward,
                       length,
                       thickness_of(b.material, s.model())});
    }
  return edges;
}

namespace {

/// Integrals of the shape functions of a face times its normal, of a triangle the same for each [m2].
std::array<Vector<3>, 4> shares_of(const LoadedFace& face) {
  if (face.count == 4) return shares_of_corners(std::array<Vector<3>, 4>{face.x[0], face.x[1], face.x[2], face.x[3]});
  const auto third = (1.0 / 6) * cross(face.x[1] - face.x[0], face.x[2] - face.x[0]);
  return {third, third, third, Vector<3>{}};
}

/// Whether the normals point to where the cell of the face is.
bool points_inward(const Block<3>& mesh, const TaggedFacet& facet, const Vector<3>& normal) {
  const auto& x0 = mesh.position[facet.node[0]];
  for (const auto& cell : mesh.cells) {
    int common = 0;
    Vector<3> middle{};
    for (int i = 0; i < cell.count; ++i) {
      common += std::count(facet.node.begin(), facet.node.begin() + facet.count, cell.node[i]) > 0;
      middle = middle + (1.0 / cell.count) * mesh.position[cell.node[i]];
    }
    if (common == facet.count) return dot(normal, middle - x0) > 0;
  }
  return false;
}

}  // namespace

std::vector<LoadedFace> faces_of_set(const Structure<3>& s, const FacetSet& set) {
  std::vector<LoadedFace> faces;
  for (const auto& b : s.blocks())
    for (const auto& f : b.mesh.facets) {
      if (!set.has(b.mesh, f)) continue;
      LoadedFace face{};
      face.count = f.count;
      std::array<int, 4> node{-1, -1, -1, -1};
      for (int i = 0; i < f.count; ++i) {
        node[i] = b.first_local + f.node[i];
        face.x[i] = b.mesh.position[f.node[i]];
      }
      static_cast<Bearers&>(face) = bearers_of(s, node);
      const auto share = shares_of(face);
      const double side = points_inward(b.mesh, f, share[0] + share[1] + share[2] + share[3]) ? -1 : 1;
      for (int i = 0; i < f.count; ++i) face.outward[i] = side * share[i];
      faces.push_back(face);
    }
  return faces;
}

namespace {

/// A point of a triangle, by what each of its corners has of it.
using SharesOfCorners = std::array<double, 3>;

/// What of a polygon lies in a slab, cut at its two ends.
/// @param corner  [m] coordinates of the corners of the triangle along the axis of the slab
std::vector<SharesOfCorners> cut(std::vector<SharesOfCorners> polygon, const std::array<double, 3>& corner,
                                 const Slab& slab) {
  for (const double side : {1.0, -1.0}) {
    const double most = side * (side > 0 ? slab.high : slab.low);
    std::vector<SharesOfCorners> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto& a = polygon[i];
      const auto& b = polygon[(i + 1) % polygon.size()];
      const double at_a = side * dot(a, corner), at_b = side * dot(b, corner);
      if (at_a <= most) kept.push_back(a);
      if ((at_a <= most) != (at_b <= most)) kept.push_back(a + ((most - at_a) / (at_b - at_a)) * (b - a));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// Shares of the corners of a triangle in a point, and its part of the area: exact to the third degree, that of a
/// linear traction on an edge that bends.
constexpr std::array<std::array<double, 4>, 7> third_degree{{{1, 0, 0, 1. / 20},
                                                             {0, 1, 0, 1. / 20},
                                                             {0, 0, 1, 1. / 20},
                                                             {1. / 2, 1. / 2, 0, 2. / 15},
                                                             {0, 1. / 2, 1. / 2, 2. / 15},
                                                             {1. / 2, 0, 1. / 2, 2. / 15},
                                                             {1. / 3, 1. / 3, 1. / 3, 9. / 20}}};

/// Adds points for one triangle of a face.
void add_points(const LoadedFace& face, const std::array<int, 3>& corner, double weight, const std::vector<Slab>& slabs,
                std::vector<FacePoint>& points) {
  const auto& x = face.x;
  auto normal = cross(x[corner[1]] - x[corner[0]], x[corner[2]] - x[corner[0]]);
  const double twice = norm(normal);
  if (twice == 0) return;
  const bool inward = dot(normal, face.outward[0] + face.outward[1] + face.outward[2] + face.outward[3]) < 0;
  normal = ((inward ? -1 : 1) / twice) * normal;
  std::vector<SharesOfCorners> polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& slab : slabs)
    polygon =
        cut(polygon, {x[corner[0]][slab.component], x[corner[1]][slab.component], x[corner[2]][slab.component]}, slab);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const std::array<SharesOfCorners, 3> part{polygon[0], polygon[i - 1], polygon[i]};
    const double share = dot(part[0], cross(part[1], part[2]));  // of the area of the triangle
    for (const auto& [a, b, c, of_area] : third_degree) {
      const auto shares = a * part[0] + b * part[1] + c * part[2];
      FacePoint point{{}, normal, weight * share * of_area * twice / 2, {}};
      for (int k = 0; k < 3; ++k) {
        point.at = point.at + shares[k] * x[corner[k]];
        point.share[corner[k]] = shares[k];
      }
      points.push_back(point);
    }
  }
}

}  // namespace

std::vector<FacePoint> points_of(const LoadedFace& face, const std::vector<Slab>& slabs) {
  std::vector<FacePoint> points;
  if (face.count == 3) {
    add_points(face, {0, 1, 2}, 1, slabs, points);
    return points;
  }
  for (const auto& corner : {std::array<int, 3>{0, 1, 2}, {2, 3, 0}, {1, 2, 3}, {3, 0, 1}})
    add_points(face, corner, 0.5, slabs, points);
  return points;
}

PartOfEdge part_between(const LoadedEdge& e, int c, double low, double high) {
  const double start = e.x[0][c], rise = e.x[1][c] - e.x[0][c];
  if (rise == 0) return start >= low && start <= high ? PartOfEdge{0, 1} : PartOfEdge{1, 0};
  const double a = (low - start) / rise, b = (high - start) / rise;
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

}  // namespace voussoir
