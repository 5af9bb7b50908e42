#include "loads/facets.hpp"

#include <algorithm>

#include "mesh/face_shares.hpp"

namespace voussoir {

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
      edges.push_back(
          {{b.first_local + f.node[0], b.first_local + f.node[1]}, {x0, x1}, (1 / length) * outward, length});
    }
  return edges;
}

namespace {

/// Whether the normals point to where the cell of the face is.
bool points_inward(const Block<3>& mesh, const TaggedFacet& facet, const Vector<3>& normal) {
  const auto& x0 = mesh.position[facet.node[0]];
  for (const auto& cell : mesh.cells) {
    int common = 0;
    Vector<3> middle{};
    for (int i = 0; i < cell.count; ++i) {
      common += std::count(facet.node.begin(), facet.node.end(), cell.node[i]) > 0;
      middle = middle + (1.0 / cell.count) * mesh.position[cell.node[i]];
    }
    if (common == 4) return dot(normal, middle - x0) > 0;
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
      std::array<Vector<3>, 4> x;
      for (int i = 0; i < 4; ++i) {
        face.node[i] = b.first_local + f.node[i];
        x[i] = b.mesh.position[f.node[i]];
      }
      const auto share = shares_of_corners(x);
      const double side = points_inward(b.mesh, f, share[0] + share[1] + share[2] + share[3]) ? -1 : 1;
      for (int i = 0; i < 4; ++i) face.outward[i] = side * share[i];
      faces.push_back(face);
    }
  return faces;
}

PartOfEdge part_between(const LoadedEdge& e, int c, double low, double high) {
  const double start = e.x[0][c], rise = e.x[1][c] - e.x[0][c];
  if (rise == 0) return start >= low && start <= high ? PartOfEdge{0, 1} : PartOfEdge{1, 0};
  const double a = (low - start) / rise, b = (high - start) / rise;
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

}  // namespace voussoir
