#include "stones/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "stones/facets.hpp"
#include "stones/solid.hpp"

namespace voussoir {
namespace {

// Lines in each of three directions through what the boxes of two stones have in common: so an overlap is found that is
// a seventh of that in two of them, however thin in the third. Deeper ones that are smaller hold a corner of a stone.
constexpr int lines_across = 7;

// [-] of the distance between lines: they do not lie in planes of a drawing.
constexpr std::array<double, 2> off_planes{0.4711, 0.5389};

// [-] of a depth: places are told inside from outside at twice of it from surfaces.
constexpr double nearby = 0.5;

Box<3> common(const Box<3>& a, const Box<3>& b) {
  auto both = a;
  for (int i = 0; i < 3; ++i) {
    both.low[i] = std::max(a.low[i], b.low[i]);
    both.high[i] = std::min(a.high[i], b.high[i]);
  }
  return both;
}

/// Two stones, and the deepest place of one in the other so far.
class TwoSolids {
 public:
  /// @param depth  [m] from which an overlap counts
  TwoSolids(const Solid& a, const Solid& b, double depth)
      : solid_{&a, &b}, both_(common(a.box(), b.box())), depth_(depth) {}

  /// Corners of either in the other, as far as they are from its surface.
  void look_at_corners() {
    for (int one = 0; one < 2; ++one)
      for (const auto& x : solid_[one]->points())
        if (both_.overlaps({x, x})) take(x, depth_of_corner(*solid_[1 - one], x));
  }

  /// Lines that are in both for longer than the depth.
  void look_along(int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double du = (both_.high[u] - both_.low[u]) / lines_across, dv = (both_.high[v] - both_.low[v]) / lines_across;
    auto through = both_.low;
    for (int i = 0; i < lines_across; ++i)
      for (int j = 0; j < lines_across; ++j) {
        through[u] = both_.low[u] + (i + off_planes[0]) * du;
        through[v] = both_.low[v] + (j + off_planes[1]) * dv;
        const double aside = 0.1 * std::min(du, dv);
        const auto in_a = solid_[0]->along(axis, through, aside), in_b = solid_[1]->along(axis, through, aside);
        for (const auto& a : in_a)
          for (const auto& b : in_b) look_between(axis, through, a, b);
      }
  }

  double deepest() const { return deepest_; }
  const Vector<3>& place() const { return place_; }

 private:
  double depth_of_corner(const Solid& other, const Vector<3>& x) const {
    if (other.distance(x, depth_) < depth_ || !other.holds(x, nearby * depth_)) return 0;
    return other.distance(x, std::numeric_limits<double>::infinity());
  }

  /// A line that is in one stone from a[0] to a[1] and in the other from b[0] to b[1]. Where both begin and end places
  /// on the surface of one are as deep as the other's is far; in the middle a ball lies in both.
  void look_between(int axis, Vector<3> through, const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const double from = std::max(a[0], b[0]), to = std::min(a[1], b[1]);
    if (to - from <= depth_) return;
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double end : {from, to}) {
      through[axis] = end;
      const int owner = end == a[0] || end == a[1] ? 0 : 1;
      take(through, solid_[1 - owner]->distance(through, infinity));
    }
    through[axis] = (from + to) / 2;
    take(through, 2 * std::min(solid_[0]->distance(through, infinity), solid_[1]->distance(through, infinity)));
  }

  void take(const Vector<3>& place, double depth) {
    if (!(depth > deepest_)) return;
    deepest_ = depth;
    place_ = place;
  }

  std::array<const Solid*, 2> solid_;
  Box<3> both_;
  double depth_;
  double deepest_ = 0;
  Vector<3> place_{};
};

// Chords of what is round are those of an eighth of a turn at most: what has fewer sides is a prism.
constexpr double cosine_of_chords = 0.7071;

/// [m] the highest arc over a plane facet at a place, where it is one of a row that turns one way, as chords do.
double arc_over_chord(const FacetedStone& stone, const Vector<3>& place, double near) {
  std::map<std::array<int, 2>, int> facet_left_of;
  for (std::size_t f = 0; f < stone.facets.size(); ++f)
    for (const auto& e : stone.facets[f].edges) facet_left_of[e] = static_cast<int>(f);
  const auto& x = stone.surface->points;
  double highest = 0;
  for (const auto& facet : stone.facets) {
    if (!widened(facet.box, near).overlaps({place, place})) continue;
    std::array<std::set<int>, 2> turns_to;  // facets to which it turns outward and inward
    std::array<double, 2> height{};
    for (const auto& e : facet.edges) {
      const auto found = facet_left_of.find({e[1], e[0]});
      const auto& next = found == facet_left_of.end() ? facet : stone.facets[found->second];
      const double cosine = dot(facet.normal, next.normal);
      if (&next == &facet || cosine < cosine_of_chords) continue;
      const auto along = x[e[1]] - x[e[0]], across = (1 / norm(along)) * cross(facet.normal, along);
      const auto turn = cross(facet.normal, next.normal);
      double width = 0;
      for (const auto& other : facet.edges) width = std::max(width, dot(x[other[0]] - x[e[0]], across));
      const int way = dot(turn, along) > 0 ? 0 : 1;
      turns_to[way].insert(found->second);
      height[way] = std::max(height[way], width / 2 * std::tan(std::atan2(norm(turn), cosine) / 4));
    }
    for (int way = 0; way < 2; ++way)
      if (turns_to[way].size() > 1) highest = std::max(highest, height[way]);
  }
  return highest;
}

}  // namespace

std::vector<StoneOverlap> overlaps(const std::vector<StoneSurface>& stones, double depth) {
  std::vector<Solid> solids;
  std::vector<Box<3>> boxes;
  for (const auto& stone : stones) {
    solids.emplace_back(stone);
    boxes.push_back(solids.back().box());
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
      TwoSolids pair(solids[a], solids[b], depth);
      pair.look_at_corners();
      for (int axis = 0; axis < 3; ++axis) pair.look_along(axis);
      if (!(pair.deepest() > depth)) continue;
      StoneOverlap overlap{{a, b}, pair.deepest(), pair.place(), 0};
      for (const int stone : {a, b})
        overlap.of_chords += arc_over_chord(facets_of(stones[stone], depth), overlap.place, overlap.depth);
      found.push_back(overlap);
    }
  }
  return found;
}

}  // namespace voussoir
