#include "stones/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "stones/facets.hpp"
#include "stones/polygon.hpp"

namespace voussoir {
namespace {

using TriangleOfPlaces = std::array<Vector<3>, 3>;

/// How much of the unit sphere around a place a triangle hides, signed.
///
/// Theory  A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
double solid_angle(const TriangleOfPlaces& t, const Vector<3>& place) {
  const auto a = t[0] - place, b = t[1] - place, c = t[2] - place;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2 * std::atan2(dot(a, cross(b, c)), below);
}

double distance_to_segment(const Vector<3>& a, const Vector<3>& b, const Vector<3>& place) {
  const auto along = b - a;
  const double squared = dot(along, along);
  const double part = squared > 0 ? std::clamp(dot(place - a, along) / squared, 0.0, 1.0) : 0;
  return norm(place - a - part * along);
}

double distance(const TriangleOfPlaces& t, const Vector<3>& place) {
  const auto normal = cross(t[1] - t[0], t[2] - t[0]);
  const double size = norm(normal);
  bool above = size > 0;
  for (int k = 0; k < 3 && above; ++k) above = dot(cross(t[(k + 1) % 3] - t[k], place - t[k]), normal) >= 0;
  if (above) return std::abs(dot(place - t[0], normal)) / size;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) least = std::min(least, distance_to_segment(t[k], t[(k + 1) % 3], place));
  return least;
}

/// A stone as triangles.
struct Solid {
  std::vector<TriangleOfPlaces> triangles;
  std::vector<std::array<Vector<3>, 2>> edges;
  Places points;
  Vector<3> centre{};
  Box<3> box{};

  explicit Solid(const StoneSurface& stone) : points(stone.points), centre(mean(stone.points)), box(box_of(points)) {
    std::set<std::pair<int, int>> known;
    for (const auto& face : stone.faces) {
      const auto corners = places_of(stone.points, face);
      for (const auto& t : cut_into_triangles(corners))
        triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int a = face[k], b = face[(k + 1) % face.size()];
        if (known.insert(std::minmax(a, b)).second) edges.push_back({points[a], points[b]});
      }
    }
  }

  double depth(const Vector<3>& place) const {
    double angle = 0, least = std::numeric_limits<double>::infinity();
    for (const auto& t : triangles) {
      angle += solid_angle(t, place);
      least = std::min(least, distance(t, place));
    }
    return angle > 2 * std::acos(-1.0) ? least : -least;  // half the sphere: 2 pi, of 4 pi inside
  }

  bool box_holds(const Vector<3>& place) const { return box.overlaps({place, place}); }
};

/// Where along an edge, from 0 to 1, it goes through a triangle of a stone, with both ends.
std::vector<double> ways_through(const Solid& stone, const Vector<3>& from, const Vector<3>& to) {
  std::vector<double> at{0, 1};
  for (const auto& t : stone.triangles) {
    const auto normal = cross(t[1] - t[0], t[2] - t[0]);
    const double first = dot(from - t[0], normal), last = dot(to - t[0], normal);
    if ((first < 0) == (last < 0)) continue;
    const double part = first / (first - last);
    const auto place = from + part * (to - from);
    bool inside = true;
    for (int k = 0; k < 3 && inside; ++k) inside = dot(cross(t[(k + 1) % 3] - t[k], place - t[k]), normal) >= 0;
    if (inside) at.push_back(part);
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// Looks at places of one stone in another.
class Look {
 public:
  Look(const Solid& in, StoneOverlap& found) : in_(in), found_(found) {}

  void at(const Vector<3>& place) {
    if (!in_.box_holds(place)) return;
    const double depth = in_.depth(place);
    if (depth > found_.depth) found_.depth = depth, found_.place = place;
  }

  /// @param depth  [m] how far inside of faces places are looked at too
  void all_of(const Solid& stone, double depth) {
    for (const auto& x : stone.points) at(x);
    for (const auto& [from, to] : stone.edges) {
      Box<3> box{from, from};
      box.add({to, to});
      if (!box.overlaps(in_.box)) continue;
      const auto ways = ways_through(in_, from, to);
      for (std::size_t k = 0; k + 1 < ways.size(); ++k) at(from + ((ways[k] + ways[k + 1]) / 2) * (to - from));
    }
    for (const auto& t : stone.triangles) {
      const auto middle = (1.0 / 3) * (t[0] + t[1] + t[2]);
      const auto normal = cross(t[1] - t[0], t[2] - t[0]);
      at(middle);
      const auto behind = middle - (2 * depth / norm(normal)) * normal;
      if (norm(normal) > 0 && in_.box_holds(behind) && stone.depth(behind) > 0) at(behind);
    }
    if (in_.box_holds(stone.centre) && stone.depth(stone.centre) > 0) at(stone.centre);
  }

 private:
  const Solid& in_;
  StoneOverlap& found_;
};

}  // namespace

double distance_between(const StoneSurface& one, const StoneSurface& other) {
  const Solid a(one), b(other);
  double least = std::numeric_limits<double>::infinity();
  for (const auto* pair : {&a, &b})
    for (const auto& x : (pair == &a ? b : a).points)
      for (const auto& t : pair->triangles) least = std::min(least, distance(t, x));
  return least;
}

double depth_inside(const StoneSurface& stone, const Vector<3>& place) { return Solid(stone).depth(place); }

std::vector<StoneOverlap> overlaps(const std::vector<StoneSurface>& stones, double depth) {
  std::vector<Solid> solids;
  std::vector<Box<3>> boxes;
  for (const auto& stone : stones) {
    solids.emplace_back(stone);
    boxes.push_back(solids.back().box);
  }
  const BoxTree<3> tree(boxes);
  std::vector<StoneOverlap> found;
  for (int a = 0; a < static_cast<int>(stones.size()); ++a) {
    Box<3> narrowed = boxes[a];  // boxes that overlap by less than the depth hold no such overlap
    for (int i = 0; i < 3; ++i) narrowed.low[i] += depth, narrowed.high[i] -= depth;
    std::vector<int> others;
    tree.visit_overlaps(narrowed, [&](int b) {
      if (b > a) others.push_back(b);
    });
    std::sort(others.begin(), others.end());
    for (const int b : others) {
      StoneOverlap overlap{{a, b}, 0, {}};
      Look(solids[b], overlap).all_of(solids[a], depth);
      Look(solids[a], overlap).all_of(solids[b], depth);
      if (overlap.depth > depth) found.push_back(overlap);
    }
  }
  return found;
}

}  // namespace voussoir
