#include "mesh/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

double distance(const OutlineEdge& edge, const Vector<2>& x) {
  const auto along = edge.to - edge.from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(x - edge.from, along) / square, 0.0, 1.0) : 0.0;
  return norm(x - edge.from - share * along);
}

// Two stones lie flush when each keeps to their common line within what the check of a drawing takes for touching, 1 %
// of a cell: a step, and a bend over the length of a cell.
constexpr double flush = 0.02;
// A point stands for half a cell on either side: across a narrower gap it has face beneath it.
constexpr double bridged = 0.5;

bool go_on_flush(const OutlineEdge& one, const OutlineEdge& other, double cell) {
  const auto along = one.to - one.from, next = other.to - other.from;
  if (!(norm(along) > 0) || !(norm(next) > 0)) return false;
  const Vector<2> way = (1 / norm(along)) * along;
  if (dot(way, next) <= 0 || std::abs(cross(way, next)) > flush * norm(next)) return false;
  const bool ahead = dot(way, other.from + other.to - one.from - one.to) > 0;
  const auto between = ahead ? other.from - one.to : one.from - other.to;
  return dot(way, between) <= bridged * cell && std::abs(cross(way, between)) <= flush * cell;
}

/// Nodes of the border and middles of its edges that lie deeper in another block than a tolerance.
std::vector<Vector<2>> places_within(const Outline& one, const Outline& other, double tolerance) {
  std::vector<Vector<2>> found;
  for (const auto& edge : one)
    for (const auto& x : {edge.from, 0.5 * (edge.from + edge.to)})
      if (inside(other, x) && distance_to_border(other, x) > tolerance) found.push_back(x);
  return found;
}

/// The way from a place within a block along a direction until it first meets the border, corners included [m].
double way_out(const Outline& outline, const Vector<2>& x, const Vector<2>& direction) {
  double nearest = none;
  for (const auto& edge : outline) {
    const double from = cross(direction, edge.from - x), to = cross(direction, edge.to - x);
    if (from * to > 0 || from == to) continue;  // an edge along the way: its neighbours have its ends
    const auto meets = edge.from + (from / (from - to)) * (edge.to - edge.from);
    const double way = dot(meets - x, direction);
    if (way > 0) nearest = std::min(nearest, way);
  }
  return nearest == none ? 0.0 : nearest;
}

/// Directions along which the first of two blocks may be drawn back: against its own outward normals, along those of
/// the other.
std::vector<Vector<2>> ways_back(const Outline& one, const Outline& other) {
  constexpr double same = 1e-6;  // [rad] normals of edges along one face
  std::vector<Vector<2>> ways;
  const auto add = [&](const OutlineEdge& edge, double sign) {
    const auto along = edge.to - edge.from;
    if (!(norm(along) > 0)) return;
    const Vector<2> way = (sign / norm(along)) * Vector<2>{along[1], -along[0]};
    const bool known = std::any_of(ways.begin(), ways.end(), [&](const Vector<2>& w) { return norm(w - way) < same; });
    if (!known) ways.push_back(way);
  };
  for (const auto& edge : one) add(edge, -1);
  for (const auto& edge : other) add(edge, 1);
  return ways;
}

}  // namespace

std::vector<std::array<int, 2>> border_of(const std::vector<Cell>& cells) {
  std::vector<std::array<int, 2>> sides, border;
  for (const auto& cell : cells)
    for (int k = 0; k < cell.count; ++k) sides.push_back({cell.node[k], cell.node[(k + 1) % cell.count]});
  const auto key = [](const std::array<int, 2>& side) {
    return std::array<int, 2>{std::min(side[0], side[1]), std::max(side[0], side[1])};
  };
  std::sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    while (to < sides.size() && key(sides[to]) == key(sides[from])) ++to;
    if (to == from + 1) border.push_back(sides[from]);
  }
  return border;
}

double shortest_side(const std::vector<Cell>& cells, const Vector<2>* position) {
  double shortest = none;
  for (const auto& cell : cells)
    for (int k = 0; k < cell.count; ++k)
      shortest = std::min(shortest, norm(position[cell.node[(k + 1) % cell.count]] - position[cell.node[k]]));
  return shortest;
}

bool inside(const Outline& outline, const Vector<2>& x) {
  bool within = false;
  for (const auto& [from, to] : outline) {
    if ((from[1] > x[1]) == (to[1] > x[1])) continue;
    const double crossing = from[0] + (x[1] - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
    if (crossing > x[0]) within = !within;
  }
  return within;
}

double distance_to_border(const Outline& outline, const Vector<2>& x) {
  double nearest = none;
  for (const auto& edge : outline) nearest = std::min(nearest, distance(edge, x));
  return nearest;
}

double overlap_depth(const Outline& one, const Outline& other, double tolerance) {
  const auto of_one = places_within(one, other, tolerance), of_other = places_within(other, one, tolerance);
  if (of_one.empty() && of_other.empty()) return 0;
  double least = none;
  for (const auto& back : ways_back(one, other)) {
    double way = 0;
    for (const auto& x : of_one) way = std::max(way, way_out(other, x, back));
    for (const auto& x : of_other) way = std::max(way, way_out(one, x, -1.0 * back));
    least = std::min(least, way);
  }
  return least;
}

Outline with_what_goes_on_flush(const Outline& face, const Outline& others, double cell) {
  auto found = face;
  std::vector<char> taken(others.size(), 0);
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::size_t n = 0; n < others.size(); ++n) {
      if (taken[n] || !go_on_flush(found[k], others[n], cell)) continue;
      taken[n] = 1;
      found.push_back(others[n]);
    }
  return found;
}

}  // namespace voussoir
