#include "range/space/stone_surfaces.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/border.hpp"
#include "stones/overlaps.hpp"

namespace voussoir {

StoneSurface surface_now(const Structure<3>& s, const std::vector<double>& u, int block) {
  const auto& local = s.blocks()[block];
  Block<3> alone;
  alone.id = local.id;
  alone.cells = local.mesh.cells;
  alone.vertex.resize(static_cast<std::size_t>(local.nodes));
  std::iota(alone.vertex.begin(), alone.vertex.end(), 0);
  StoneSurface surface;
  for (int i = 0; i < local.nodes; ++i) surface.points.push_back(place_now(s, u, local.first_local + i));
  for (const auto& face : border_faces({alone})) {
    surface.faces.emplace_back(face.node.begin(), face.node.end());
    if (face.node[3] == face.node[2]) surface.faces.back().pop_back();
  }
  return surface;
}

double distance_outside(const StoneSurface& surface, const Vector<3>& place) {
  return std::max(0.0, -depth_inside(surface, place));
}

}  // namespace voussoir
