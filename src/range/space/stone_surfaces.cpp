#include "range/space/stone_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "linalg/parcels.hpp"
#include "mesh/border.hpp"
#include "mesh/bytes.hpp"
#include "range/boxes_of_ranks.hpp"
#include "range/turn_records.hpp"

namespace voussoir {
namespace {

Box<3> box_around(const std::vector<Vector<3>>& points) {
  auto box = empty_box<3>();
  for (const auto& x : points) box.add({x, x});
  return box;
}

/// Writes a stone for another rank, or reads it.
template <class Bytes, class Stone>
void each_value(Bytes& bytes, Stone& stone) {
  bytes.plain(stone.block);
  bytes.plain(stone.turn);
  bytes.plain(stone.box);
  plain_list(bytes, stone.surface.points);
  const auto faces = bytes.size(stone.surface.faces, sizeof(std::size_t));
  for (std::size_t f = 0; f < faces; ++f) plain_list(bytes, stone.surface.faces[f]);
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
  for (const auto& face : border_facets<3>({alone})) {
    surface.faces.emplace_back(face.node.begin(), face.node.end());
    if (face.node[3] == face.node[2]) surface.faces.back().pop_back();
  }
  return surface;
}

std::vector<PlacedSurface> surfaces_here(const SpaceModel& model, const StepEnd& end) {
  const auto& s = model.structure();
  const auto& u = end.state.displacement;
  const bool followed = is_followed(model, end);
  std::vector<PlacedSurface> all;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    auto surface = surface_now(s, u, b);
    const auto box = box_around(surface.points);
    all.push_back({s.blocks()[b].id, std::move(surface), followed ? 0.0 : norm(turn_of(s, b, u)), box});
  }
  return all;
}

std::vector<PlacedSurface> surfaces_in(const Box<3>& mine, const std::vector<PlacedSurface>& here,
                                       const Teuchos::Comm<int>& comm) {
  const auto boxes = boxes_of_ranks(mine, comm);
  std::vector<Parcel<char>> parcels;
  for (int rank = 0; rank < comm.getSize(); ++rank) {
    ByteWriter to;
    for (const auto& stone : here)
      if (boxes[rank].overlaps(stone.box)) each_value(to, stone);
    parcels.push_back({rank, {to.bytes.begin(), to.bytes.end()}});
  }
  std::vector<PlacedSurface> all;
  for (const auto& parcel : exchange_parcels(std::move(parcels), comm)) {
    const std::string bytes(parcel.items.begin(), parcel.items.end());
    for (ByteReader from(bytes); from.left() > 0;) each_value(from, all.emplace_back());
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
  return all;
}

}  // namespace voussoir
