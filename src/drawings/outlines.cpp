// What can be said of the outline of one stone, whatever its neighbours are.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/snapped.hpp"
#include "stones/drawing.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

/// Of the size of a loop: points that are nearer are one, written with the digits of a text.
constexpr double same_point = 1e-9;

/// [m] no building is as large, nor as far from its origin: numbers of a damaged file.
constexpr double farthest_place = 1e9;

double size_of(const Polygon& p) {
  double size = 0;
  for (const auto& x : p) size = std::max(size, norm(x - p[0]));
  return size;
}

void drop_doubles(DrawnLoop& loop) {
  const double same = same_point * size_of(loop.corners);
  DrawnLoop left;
  for (std::size_t k = 0; k < loop.corners.size(); ++k) {
    if (!left.corners.empty() && norm(loop.corners[k] - left.corners.back()) <= same) {
      left.curved.back() = static_cast<char>(left.curved.back() && loop.curved[k]);
      continue;
    }
    left.corners.push_back(loop.corners[k]);
    left.curved.push_back(loop.curved[k]);
  }
  if (left.corners.size() > 1 && norm(left.corners.front() - left.corners.back()) <= same) {
    left.corners.pop_back();
    left.curved.pop_back();
  }
  loop = std::move(left);
}

void turn(DrawnLoop& loop, bool counter_clockwise) {
  if ((area(loop.corners) > 0) == counter_clockwise) return;
  std::reverse(loop.corners.begin(), loop.corners.end());
  std::reverse(loop.curved.begin(), loop.curved.end());
}

/// Where two edges cross.
Vector<2> crossing(const Drawing2& d, const std::array<int, 2>& e, const std::array<int, 2>& f) {
  const auto &a = d.points[e[0]], &b = d.points[e[1]], &c = d.points[f[0]];
  const auto along = b - a, across = d.points[f[1]] - c;
  return a + (cross(c - a, across) / cross(along, across)) * along;
}

/// What is wrong with a stone, or "".
std::string fault_of(OutlinedStone& stone) {
  for (const auto& loop : stone.loops)
    for (const auto& x : loop.corners)
      if (!(std::abs(x[0]) <= farthest_place && std::abs(x[1]) <= farthest_place))
        return "has a corner at " + place_of_drawing(x) + ", farther than 1e9 m from the origin";
  Drawing2 all;
  for (std::size_t k = 0; k < stone.loops.size(); ++k) {
    drop_doubles(stone.loops[k]);
    const auto& p = stone.loops[k].corners;
    if (p.size() < 3)
      return (k == 0 ? "has " : "has a hole that has ") + counted(p.size(), "corner") +
             ", where an outline needs three";
    const int first = static_cast<int>(all.points.size()), count = static_cast<int>(p.size());
    all.points.insert(all.points.end(), p.begin(), p.end());
    for (int i = 0; i < count; ++i) all.edges.push_back({first + i, first + (i + 1) % count});
  }
  if (const auto crossings = crossings_of(all); !crossings.empty())
    return "crosses itself at " +
           place_of_drawing(crossing(all, all.edges[crossings[0][0]], all.edges[crossings[0][1]]));
  for (std::size_t k = 0; k < stone.loops.size(); ++k) {
    auto& loop = stone.loops[k];
    const double size = size_of(loop.corners);
    if (std::abs(area(loop.corners)) <= same_point * size * size)
      return std::string(k == 0 ? "has" : "has a hole that has") + " no area: its corners lie on a line";
    turn(loop, k == 0);
    if (k > 0 && !holds(stone.loops[0].corners, loop.corners[0]))
      return "has a hole at " + place_of_drawing(loop.corners[0]) + " that lies outside of its outline";
  }
  return "";
}

/// [m] from a place to the nearest edge of a stone.
double distance_to_border(const OutlinedStone& stone, const Vector<2>& x) {
  double least = HUGE_VAL;
  for (const auto& loop : stone.loops)
    for (std::size_t k = 0; k < loop.corners.size(); ++k) {
      const auto &a = loop.corners[k], &b = loop.corners[(k + 1) % loop.corners.size()];
      const auto along = b - a;
      const double part = std::clamp(dot(x - a, along) / dot(along, along), 0.0, 1.0);
      least = std::min(least, norm(x - a - part * along));
    }
  return least;
}

bool is_inside(const OutlinedStone& stone, const Vector<2>& x) {
  bool inside = false;
  for (const auto& loop : stone.loops) inside = inside != holds(loop.corners, x);
  return inside;
}

}  // namespace

double depth_of_overlap(const OutlinedStone& one, const OutlinedStone& other, Vector<2>& place) {
  double deepest = 0;
  const auto look = [&](const OutlinedStone& in, const Vector<2>& x) {
    if (!is_inside(in, x)) return;
    const double depth = distance_to_border(in, x);
    if (depth > deepest) deepest = depth, place = x;
  };
  for (const auto& [a, b] : {std::pair<const OutlinedStone*, const OutlinedStone*>{&one, &other}, {&other, &one}})
    for (const auto& loop : a->loops)
      for (std::size_t k = 0; k < loop.corners.size(); ++k) {
        look(*b, loop.corners[k]);
        look(*b, 0.5 * (loop.corners[k] + loop.corners[(k + 1) % loop.corners.size()]));
      }
  return deepest;
}

void check_outlines(const std::string& file, std::vector<OutlinedStone>& stones) {
  std::vector<std::string> faults;
  for (auto& stone : stones)
    if (const auto fault = fault_of(stone); !fault.empty()) faults.push_back(in_words(stone) + " " + fault);
  if (faults.empty()) return;
  std::string message = "mesh > stones > file = " + file + "\n  " + std::to_string(faults.size()) + " of " +
                        counted(stones.size(), "stone") + (faults.size() == 1 ? " has" : " have") +
                        " no outline that could be a stone:";
  for (std::size_t k = 0; k < std::min<std::size_t>(faults.size(), 5); ++k) message += "\n    " + faults[k];
  throw InputError(message + "\n  Draw every stone as one closed line around it that does not cross itself.");
}

}  // namespace voussoir
