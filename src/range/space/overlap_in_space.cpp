#include "range/space/overlap_in_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
#include "range/boxes_of_ranks.hpp"
#include "range/gaps_as_drawn.hpp"
#include "range/range_parameters.hpp"
#include "range/space/stone_surfaces.hpp"
#include "range/stone_names.hpp"
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

/// By how much a small rotation makes a stone larger [m].
double growth(const PlacedSurface& stone) { return stone.turn * stone.turn / 2 * extent(stone.surface.points); }

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
  auto stones = surfaces_in(around, here, *s.comm());
  std::vector<double> grown;
  std::vector<StoneSurface> surfaces;
  for (const auto& stone : stones) grown.push_back(growth(stone));
  for (auto& stone : stones) surfaces.push_back(std::move(stone.surface));
  const GapsAsDrawn gaps(model);
  std::vector<Overlap> found;
  for (const auto& overlap : overlaps(surfaces, touching)) {
    const auto [one, other] = overlap.stone;
    const auto [a, b] = std::minmax(stones[one].block, stones[other].block);
    const int local = s.local_block(a);
    if (local < 0 || local >= s.owned_blocks()) continue;  // another rank's to tell
    if (overlap.depth > touching + grown[one] + grown[other] + gaps.between(a, b))
      found.push_back({a, b, overlap.depth});
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
