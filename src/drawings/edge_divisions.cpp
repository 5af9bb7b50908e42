// Which stones are quadrilaterals, and what that asks of the edges of their neighbours.
#include <algorithm>
#include <cmath>

#include "drawings/plane_mesh.hpp"
#include "mesh/same_side.hpp"

namespace voussoir {
namespace {

using Loop = std::vector<int>;

/// [rad] Corners of a quadrilateral turn by this at least, and by pi less this at most: 30 degrees, below which cells
/// are so slender that triangles are better.
constexpr double least_turn = 0.52;
/// A side with more cells than this many times of what it wanted is better of triangles.
constexpr int most_added = 3;

double turn_at(const Polygon& x, int before, int at, int after) {
  const auto in = x[at] - x[before], out = x[after] - x[at];
  return std::atan2(cross(in, out), dot(in, out));
}

/// Where the sides begin in the outline of a stone; empty where it has not four.
std::vector<int> sides_of(const PlaneStones& s, std::size_t stone) {
  const auto& loops = s.snapped.loops[stone];
  if (loops.size() != 1) return {};
  std::vector<int> left;  // places in the outline
  for (int k = 0; k < static_cast<int>(loops[0].size()); ++k) left.push_back(k);
  const auto turn = [&](std::size_t k) {
    const auto n = left.size();
    return turn_at(s.snapped.points, loops[0][left[(k + n - 1) % n]], loops[0][left[k]], loops[0][left[(k + 1) % n]]);
  };
  while (left.size() > 4) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < left.size(); ++k)
      if (std::abs(turn(k)) < std::abs(turn(least))) least = k;
    if (std::abs(turn(least)) > turn_of_curved) return {};
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(least));
  }
  if (left.size() != 4) return {};
  const double pi = std::acos(-1.0);
  for (std::size_t k = 0; k < 4; ++k)
    if (turn(k) < least_turn || turn(k) > pi - least_turn) return {};
  return left;
}

class Dividing {
 public:
  Dividing(const PlaneStones& s, StoneCells cells) : s_(s) {
    for (std::size_t k = 0; k < s.stones.size(); ++k) {
      divisions_.sides.push_back(cells == StoneCells::by_shape ? sides_of(s, k) : std::vector<int>{});
      for (const auto& loop : s.snapped.loops[k])
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto edge = key(loop[i], loop[(i + 1) % loop.size()]);
          const double parts = std::ceil(length(edge) / s.element_size - 1e-9);
          wanted_[edge] = divisions_.parts[edge] = static_cast<int>(std::clamp(parts, 1.0, 1e6));
        }
    }
  }

  /// Parts only grow and stones only stop being quadrilaterals, so this ends.
  EdgeDivisions run() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t k = 0; k < s_.stones.size(); ++k)
        for (std::size_t side = 0; side < 2 && !divisions_.sides[k].empty(); ++side) changed |= balance(k, side);
    }
    return std::move(divisions_);
  }

 private:
  static std::pair<int, int> key(int a, int b) { return std::minmax(a, b); }
  double length(const std::pair<int, int>& e) const {
    return norm(s_.snapped.points[e.second] - s_.snapped.points[e.first]);
  }

  std::vector<std::pair<int, int>> edges_of(std::size_t stone, std::size_t side) const {
    const auto& loop = s_.snapped.loops[stone][0];
    const auto& begin = divisions_.sides[stone];
    std::vector<std::pair<int, int>> edges;
    const auto count = static_cast<int>(loop.size());
    for (int k = begin[side]; k != begin[(side + 1) % 4]; k = (k + 1) % count)
      edges.push_back(key(loop[k], loop[(k + 1) % count]));
    return edges;
  }

  int sum(const std::vector<std::pair<int, int>>& edges, const std::map<std::pair<int, int>, int>& of) const {
    int parts = 0;
    for (const auto& e : edges) parts += of.at(e);
    return parts;
  }

  /// Gives the side with fewer parts as many as the one across, longest parts first. Returns whether anything changed.
  bool balance(std::size_t stone, std::size_t side) {
    auto few = edges_of(stone, side), many = edges_of(stone, side + 2);
    if (sum(few, divisions_.parts) > sum(many, divisions_.parts)) std::swap(few, many);
    const int target = sum(many, divisions_.parts);
    if (sum(few, divisions_.parts) == target) return false;
    if (target > most_added * sum(few, wanted_)) {
      divisions_.sides[stone].clear();
      return true;
    }
    for (int parts = sum(few, divisions_.parts); parts < target; ++parts)
      ++divisions_.parts[*std::max_element(few.begin(), few.end(), [&](const auto& a, const auto& b) {
        return length(a) / divisions_.parts[a] < length(b) / divisions_.parts[b];
      })];
    return true;
  }

  const PlaneStones& s_;
  EdgeDivisions divisions_;
  std::map<std::pair<int, int>, int> wanted_;
};

}  // namespace

EdgeDivisions divided(const PlaneStones& s, StoneCells cells) { return Dividing(s, cells).run(); }

}  // namespace voussoir
