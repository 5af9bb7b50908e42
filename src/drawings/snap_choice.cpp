#include "drawings/snap_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir {
namespace {

constexpr SnapDefaults defaults;

double area_of(const OutlinedStone& stone) {
  double sum = 0;
  for (const auto& loop : stone.loops) sum += area(loop.corners);  // those of holes are negative
  return sum;
}

}  // namespace

double extent_of(const std::vector<OutlinedStone>& stones) {
  double extent = 0;
  for (const auto& stone : stones)
    for (const auto& loop : stone.loops)
      for (const auto& x : loop.corners) extent = std::max(extent, norm(x - stones[0].loops[0].corners[0]));
  return extent;
}

double median_size(const std::vector<OutlinedStone>& stones) {
  std::vector<double> sizes;
  for (const auto& stone : stones) sizes.push_back(std::sqrt(std::max(0.0, area_of(stone))));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

double reach_of(const std::vector<OutlinedStone>& stones, double snap, bool given) {
  const double small = defaults.small_gap * median_size(stones);
  return std::max(2 * snap, given ? std::min(small, defaults.reach * snap) : small);
}

std::vector<SnapCount> count_snaps(const std::vector<OutlinedStone>& stones) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const auto& stone : stones)
    for (const auto& loop : stone.loops) narrowest = std::min(narrowest, mean_width(loop.corners));
  const double most = defaults.most * narrowest;
  const double least = std::max(defaults.least * median_size(stones), defaults.round_off * extent_of(stones));
  std::vector<SnapCount> counts;
  for (double exponent = std::ceil(std::log10(least));; ++exponent)
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
      const double snap = step * std::pow(10.0, exponent);
      if (snap > most && !counts.empty()) return counts;
      const auto s = snapped(stones, snap, reach_of(stones, snap, false));
      counts.push_back({snap, s.joints.size(), s.faults.size(), s.dropped});
    }
}

double snap_on_plateau(const std::vector<SnapCount>& counts) {
  std::size_t best = 0, length = 0;
  bool joins = false;
  for (std::size_t first = 0; first < counts.size(); ++first) {
    std::size_t end = first;
    while (end < counts.size() && counts[end].faults == 0 && counts[end].joints == counts[first].joints &&
           counts[end].dropped == counts[first].dropped)
      ++end;
    const bool more = counts[first].joints > 0;
    if (end > first && ((more && !joins) || (more == joins && end - first > length)))
      best = first, length = end - first, joins = more;
  }
  if (length > 0) return counts[best + length / 2].snap;
  return std::min_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.faults < b.faults; })
      ->snap;
}

}  // namespace voussoir
