#include "range/space/overlap_in_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/text.hpp"
#include "linalg/gather.hpp"
#include "linalg/reduce.hpp"
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

/// [m] By which a small rotation makes every stone larger, as surfaces_of_all() has them. Collective.
std::vector<double> growth_of_all(const SpaceModel& model, const StepEnd& end) {
  const auto& s = model.structure();
  std::vector<double> growth;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    if (!end.absent.empty() && end.absent[b]) continue;
    const double turn = norm(turn_of(s, b, end.state.displacement));
    growth.push_back(turn * turn / 2 * extent(surface_now(s, end.state.displacement, b).points));
  }
  return all_gather(growth, *s.comm(), WhyWhole{"a number per stone, of a structure that has moved"});
}

}  // namespace

RangeFindings look_at_overlaps(const SpaceModel& model, const StepEnd& end, double smallest_side) {
  const double touching = RangeParameters::counts_as_touching * smallest_side;
  // Stones do not lie in each other as drawn: deeper than they have moved against each other they cannot be.
  if (spread(model, end) <= touching) return {};
  auto stones = surfaces_of_all(model, end, [](const Box<3>&) { return true; });
  const auto growth = growth_of_all(model, end);
  std::vector<StoneSurface> surfaces;
  for (auto& stone : stones) surfaces.push_back(std::move(stone.surface));
  auto found = overlaps(surfaces, touching);
  const auto allowed = [&](const StoneOverlap& o) {
    return o.depth <= touching + growth[o.stone[0]] + growth[o.stone[1]];
  };
  found.erase(std::remove_if(found.begin(), found.end(), allowed), found.end());
  if (found.empty()) return {};
  const auto key = [&](const StoneOverlap& o) {
    const auto a = stones[o.stone[0]].block, b = stones[o.stone[1]].block;
    return std::make_tuple(-o.depth, std::min(a, b), std::max(a, b));
  };
  const auto& worst =
      *std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto [depth, a, b] = key(worst);
  RangeFindings findings;
  findings.warnings.push_back(
      {"stones_overlap", names_of(model, a, b), end.when, worst.depth,
       "these stones lie " + three_digits(worst.depth) +
           " m in each other: contact is known between stones that are drawn touching, along the "
           "joint they are drawn with; from where they met on, forces and motions are not those "
           "of stones that press each other" +
           and_in_others(found.size() - 1)});
  return findings;
}

}  // namespace voussoir
