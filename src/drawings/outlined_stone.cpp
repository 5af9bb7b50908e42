#include "drawings/outlined_stone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "stones/drawing.hpp"

namespace voussoir {

namespace {

Vector<2> mean_of(const Polygon& p) {
  Vector<2> sum{};
  for (const auto& x : p) sum = sum + x;
  return (1 / static_cast<double>(p.size())) * sum;
}

}  // namespace

std::string stone_name(const OutlinedStone& stone) {
  return stone.name.rfind("stone", 0) == 0 ? stone.name : "stone " + stone.name;
}

Vector<2> middle_of(const OutlinedStone& stone) {
  if (stone.loops.empty() || stone.loops[0].corners.empty()) return {};
  const auto& first = stone.loops[0].corners[0];
  Vector<2> moment{};
  double whole = 0;
  bool inside = false;
  std::vector<Polygon> loops;
  for (const auto& loop : stone.loops) loops.push_back(loop.corners);
  for (const auto& p : loops)
    for (std::size_t k = 1; k + 1 < p.size(); ++k) {
      const auto b = p[k] - p[0], c = p[k + 1] - p[0];
      const double part = cross(b, c) / 2;
      whole += part;
      moment = moment + part * (p[0] - first + (1.0 / 3) * (b + c));
    }
  if (!(std::abs(whole) > 0)) return mean_of(stone.loops[0].corners);
  const Vector<2> centre = first + (1 / whole) * moment;
  for (const auto& p : loops) inside = inside != holds(p, centre);
  return inside ? centre : point_inside(loops);
}

std::string place_of_drawing(const Vector<2>& x) {
  constexpr double least = 1e-9;  // is none, but what sums leave of coordinates that cancel
  const auto digits = [](double c) { return six_digits(std::abs(c) < least ? 0 : c); };
  return "(" + digits(x[0]) + ", " + digits(x[1]) + ")";
}

std::string in_words(const OutlinedStone& stone) {
  return "stone " + in_quotes(stone.name) + " (" + stone.origin + ") at " + place_of_drawing(middle_of(stone));
}

std::vector<OutlinedStone> stones_of_loops(const OutlinedStone& named, std::vector<DrawnLoop> loops) {
  const auto size_of = [](const DrawnLoop& loop) { return std::abs(area(loop.corners)); };
  std::vector<int> depth(loops.size(), 0), holder(loops.size(), -1);
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (std::size_t other = 0; other < loops.size(); ++other) {
      if (other == k || loops[k].corners.empty() || !holds(loops[other].corners, loops[k].corners[0])) continue;
      ++depth[k];
      if (holder[k] < 0 || size_of(loops[other]) < size_of(loops[holder[k]])) holder[k] = static_cast<int>(other);
    }
  std::vector<OutlinedStone> stones;
  std::vector<int> stone_of(loops.size(), -1);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (depth[k] % 2 == 1) continue;
    stone_of[k] = static_cast<int>(stones.size());
    stones.push_back(named);
    stones.back().loops = {loops[k]};
    if (stone_of[k] > 0) stones.back().name += " (" + std::to_string(stone_of[k] + 1) + ")";
  }
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (depth[k] % 2 == 1 && stone_of[holder[k]] >= 0) stones[stone_of[holder[k]]].loops.push_back(std::move(loops[k]));
  return stones;
}

}  // namespace voussoir
