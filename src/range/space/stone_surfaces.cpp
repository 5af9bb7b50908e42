#include "range/space/stone_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "linalg/parcels.hpp"
#include "mesh/border.hpp"
#include "range/boxes_of_ranks.hpp"
#include "stones/overlaps.hpp"

namespace voussoir {
namespace {

/// How much of the lists of all a stone has.
struct Share {
  BlockId block;
  int points, faces;
};

Box<3> box_around(const std::vector<Vector<3>>& points) {
  auto box = empty_box<3>();
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

namespace {

/// Stones one after the other, for another rank.
struct PackedSurfaces {
  std::vector<Share> shares;
  std::vector<Vector<3>> points;
  std::vector<std::array<int, 4>> faces;

  void add(const PlacedSurface& stone) {
    shares.push_back(
        {stone.block, static_cast<int>(stone.surface.points.size()), static_cast<int>(stone.surface.faces.size())});
    points.insert(points.end(), stone.surface.points.begin(), stone.surface.points.end());
    for (const auto& face : stone.surface.faces)
      faces.push_back({face[0], face[1], face[2], face.size() == 4 ? face[3] : -1});
  }
  /// What ranks have sent, added to a list.
  static void unpack(const std::vector<Share>& shares, std::vector<Vector<3>>::const_iterator point,
                     std::vector<std::array<int, 4>>::const_iterator face, std::vector<PlacedSurface>& all) {
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
  }
};

template <class T>
std::vector<T> sent(std::vector<PackedSurfaces>& packed, std::vector<T> PackedSurfaces::*list,
                    const Teuchos::Comm<int>& comm) {
  std::vector<Parcel<T>> parcels;
  for (int rank = 0; rank < comm.getSize(); ++rank) parcels.push_back({rank, std::move(packed[rank].*list)});
  std::vector<T> all;
  for (const auto& parcel : exchange_parcels(std::move(parcels), comm))
    all.insert(all.end(), parcel.items.begin(), parcel.items.end());
  return all;
}

}  // namespace

std::vector<PlacedSurface> surfaces_here(const SpaceModel& model, const StepEnd& end) {
  const auto& s = model.structure();
  std::vector<PlacedSurface> all;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    PlacedSurface stone{s.blocks()[b].id, surface_now(s, end.state.displacement, b), {}};
    stone.box = box_around(stone.surface.points);
    all.push_back(std::move(stone));
  }
  return all;
}

std::vector<PlacedSurface> surfaces_in(const Box<3>& mine, const SpaceModel& model, const StepEnd& end) {
  const auto& comm = *model.structure().comm();
  const auto boxes = boxes_of_ranks(mine, comm);
  const auto here = surfaces_here(model, end);
  std::vector<PackedSurfaces> packed(boxes.size());
  std::vector<PlacedSurface> all;
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    for (const auto& stone : here)
      if (boxes[rank].overlaps(stone.box)) packed[rank].add(stone);
  const auto shares = sent(packed, &PackedSurfaces::shares, comm);
  const auto points = sent(packed, &PackedSurfaces::points, comm);
  const auto faces = sent(packed, &PackedSurfaces::faces, comm);
  PackedSurfaces::unpack(shares, points.begin(), faces.begin(), all);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
  return all;
}

}  // namespace voussoir
