#include "range/space/overlap_in_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "range/boxes_of_ranks.hpp"
#include "range/range_parameters.hpp"
#include "range/space/stone_surfaces.hpp"
#include "range/stone_names.hpp"
#include "range/turn_records.hpp"
#include "stones/facets.hpp"
#include "stones/overlaps.hpp"

namespace voussoir {
namespace {

/// How far stones have moved against each other at most [m]. Collective.
double spread(const SpaceModel& model, const StepEnd& end) {
  std::array<double, 6> range;
  range.fill(-INFINITY);
  for (int n = 0; n < model.structure().owned_nodes(); ++n)
    for (int c = 0; c < 3; ++c) {
      const double u = end.state.displacement[3 * static_cast<std::size_t>(n) + c];
      range[2 * c] = std::max(range[2 * c], u);
      range[2 * c + 1] = std::max(range[2 * c + 1], -u);
    }
  const auto all = largest_of_each(*model.structure().comm(), range);
  return norm(Vector<3>{all[0] + all[1], all[2] + all[3], all[4] + all[5]});
}

struct GrownStone {
  BlockId block;
  double growth;  ///< [m] by which a small rotation makes it larger
};

std::vector<GrownStone> growth_here(const SpaceModel& model, const StepEnd& end,
                                    const std::vector<PlacedSurface>& here) {
  std::vector<GrownStone> all;
  for (const auto& stone : here) {
    const double turn =
        norm(turn_of(model.structure(), model.structure().local_block(stone.block), end.state.displacement));
    all.push_back({stone.block, turn * turn / 2 * extent(stone.surface.points)});
  }
  return all;
}

/// Of stones that surfaces_in() has brought. Collective.
std::map<BlockId, double> growth_in(const Box<3>& mine, const SpaceModel& model, const StepEnd& end,
                                    const std::vector<PlacedSurface>& here) {
  const auto& comm = *model.structure().comm();
  const auto boxes = boxes_of_ranks(mine, comm);
  const auto grown = growth_here(model, end, here);
  Post<GrownStone> post(comm);
  for (int rank = 0; rank < comm.getSize(); ++rank)
    for (std::size_t k = 0; k < here.size(); ++k)
      if (boxes[rank].overlaps(here[k].box)) post.add(rank, grown[k]);
  std::map<BlockId, double> growth;
  for (const auto& [block, by] : std::move(post).send_all()) growth[block] = by;
  return growth;
}

struct Overlap {
  BlockId a, b;  ///< ascending
  double depth;  ///< [m]
};

/// Overlaps of the stones of this rank with those of higher numbers. Collective.
std::vector<Overlap> overlaps_here(const SpaceModel& model, const StepEnd& end, double touching) {
  const auto& s = model.structure();
  const auto here = surfaces_here(model, end);
  auto around = empty_box<3>();
  for (const auto& stone : here) around.add(stone.box);
  auto stones = surfaces_in(around, model, end);
  const auto growth = growth_in(around, model, end, here);
  std::vector<StoneSurface> surfaces;
  for (auto& stone : stones) surfaces.push_back(std::move(stone.surface));
  std::vector<Overlap> found;
  for (const auto& overlap : overlaps(surfaces, touching)) {
    const auto [a, b] = std::minmax(stones[overlap.stone[0]].block, stones[overlap.stone[1]].block);
    const int local = s.local_block(a);
    if (local < 0 || local >= s.owned_blocks()) continue;  // another rank's to tell
    if (overlap.depth > touching + growth.at(a) + growth.at(b)) found.push_back({a, b, overlap.depth});
  }
  return found;
}

}  // namespace

RangeFindings look_at_overlaps(const SpaceModel& model, const StepEnd& end, double smallest_side) {
  const double touching = RangeParameters::counts_as_touching * smallest_side;
  // Stones do not lie in each other as drawn: deeper than they have moved against each other they cannot be.
  if (spread(model, end) <= touching) return {};
  const auto found = all_gather(overlaps_here(model, end, touching), *model.structure().comm(),
                                WhyWhole{"stones that lie in each other"});
  if (found.empty()) return {};
  const auto key = [](const Overlap& o) { return std::make_tuple(-o.depth, o.a, o.b); };
  const auto& [a, b, depth] =
      *std::min_element(found.begin(), found.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
  RangeFindings findings;
  findings.warnings.push_back(
      {"stones_overlap", names_of(model, a, b), end.when, depth,
       "these stones lie " + three_digits(depth) +
           " m in each other: contact is known between stones that are drawn touching, along the "
           "joint they are drawn with; from where they met on, forces and motions are not those "
           "of stones that press each other" +
           and_in_others(found.size() - 1)});
  return findings;
}

}  // namespace voussoir
