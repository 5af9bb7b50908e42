#include "range/space/stone_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "linalg/gather.hpp"
#include "mesh/border.hpp"
#include "stones/overlaps.hpp"

namespace voussoir {
namespace {

/// How much of the lists of all a stone has.
struct Share {
  BlockId block;
  int points, faces;
};

Box<3> box_around(const std::vector<Vector<3>>& points) {
  Box<3> box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (const auto& x : points) box.add({x, x});
  return box;
}

}  // namespace

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

std::vector<PlacedSurface> surfaces_of_all(const SpaceModel& model, const StepEnd& end,
                                           const std::function<bool(const Box<3>&)>& wanted) {
  const auto& s = model.structure();
  std::vector<Share> shares;
  std::vector<Vector<3>> points;
  std::vector<std::array<int, 4>> faces;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const auto surface = surface_now(s, end.state.displacement, b);
    if (!wanted(box_around(surface.points))) continue;
    shares.push_back(
        {s.blocks()[b].id, static_cast<int>(surface.points.size()), static_cast<int>(surface.faces.size())});
    points.insert(points.end(), surface.points.begin(), surface.points.end());
    for (const auto& face : surface.faces)
      faces.push_back({face[0], face[1], face[2], face.size() == 4 ? face[3] : -1});
  }
  constexpr WhyWhole surfaces{"surfaces of stones that may meet, of a structure that has moved"};
  shares = all_gather(shares, *s.comm(), surfaces);
  points = all_gather(points, *s.comm(), surfaces);
  faces = all_gather(faces, *s.comm(), surfaces);
  std::vector<PlacedSurface> all;
  auto point = points.begin();
  auto face = faces.begin();
  for (const auto& share : shares) {
    PlacedSurface stone{share.block, {}, {}};
    stone.surface.points.assign(point, point + share.points);
    for (auto f = face; f != face + share.faces; ++f) {
      stone.surface.faces.emplace_back(f->begin(), f->end());
      if (f->back() < 0) stone.surface.faces.back().pop_back();
    }
    stone.box = box_around(stone.surface.points);
    point += share.points;
    face += share.faces;
    all.push_back(std::move(stone));
  }
  return all;
}

}  // namespace voussoir
