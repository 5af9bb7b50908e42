#include "stones/stone_joints.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "stones/polygon.hpp"

namespace voussoir {
namespace {

Polygon in_plane(const PlaneAxes& axes, const Places& places) {
  Polygon polygon;
  for (const auto& x : places) polygon.push_back(axes(x));
  return polygon;
}

/// A joint as it grows by the common parts of pieces.
struct Growing {
  StoneJoint joint;
  double around = 0;  ///< [m] perimeters of its pieces
};

/// Adds what two convex pieces have in common, where the planes are near each other at every corner of it.
void add_common(Growing& growing, const StoneFacet& a, const StoneFacet& b, const PlaneAxes& axes, const Polygon& of_a,
                const Polygon& of_b, double tolerance) {
  const Polygon common = common_part(of_a, of_b);
  const double part = common.size() < 3 ? 0 : area(common);
  if (!(part > 0)) return;
  double farthest = 0, opening = 0;
  Places piece;
  for (const auto& p : common) {
    const auto x = axes.place(p);
    const double to_a = distance_along(a, x, axes.normal), to_b = distance_along(b, x, axes.normal);
    farthest = std::max(farthest, std::abs(to_b - to_a));
    opening += (to_b - to_a) / static_cast<double>(common.size());
    piece.push_back(x + ((to_a + to_b) / 2) * axes.normal);
  }
  if (farthest > tolerance) return;
  StoneJoint& joint = growing.joint;
  joint.opening = (joint.area * joint.opening + part * opening) / (joint.area + part);
  joint.area += part;
  joint.farthest = std::max(joint.farthest, farthest);
  joint.pieces.push_back(std::move(piece));
  growing.around += perimeter(common);
}

class Search {
 public:
  Search(const std::vector<FacetedStone>& stones, double width, double reach)
      : stones_(stones), width_(width), tolerance_(reach) {}

  StoneJoints run() {
    std::vector<Box<3>> boxes;
    for (const auto& stone : stones_) boxes.push_back(stone.box);
    const BoxTree<3> tree(boxes);
    for (int a = 0; a < static_cast<int>(stones_.size()); ++a) {
      std::vector<int> others;
      tree.visit_overlaps(widened(boxes[a], tolerance_), [&](int b) {
        if (b > a) others.push_back(b);
      });
      std::sort(others.begin(), others.end());
      for (const int b : others) between(a, b);
    }
    return std::move(found_);
  }

 private:
  void between(int a, int b) {
    const auto &one = stones_[a], &other = stones_[b];
    for (std::size_t i = 0; i < one.facets.size(); ++i) {
      const auto& f = one.facets[i];
      if (!widened(f.box, tolerance_).overlaps(other.box)) continue;
      for (std::size_t j = 0; j < other.facets.size(); ++j) {
        const auto& g = other.facets[j];
        if (dot(f.normal, g.normal) > -opposed || !widened(f.box, tolerance_).overlaps(g.box)) continue;
        add({a, b}, {static_cast<int>(i), static_cast<int>(j)}, f, g);
      }
    }
  }

  void add(const std::array<int, 2>& stones, const std::array<int, 2>& facets, const StoneFacet& f,
           const StoneFacet& g) {
    if (f.pieces.empty() || g.pieces.empty()) return;
    const PlaneAxes axes(f.pieces[0][0], f.normal - g.normal);
    Growing growing;
    std::vector<Polygon> of_g;
    for (const auto& piece : g.pieces) {
      of_g.push_back(in_plane(axes, piece));
      std::reverse(of_g.back().begin(), of_g.back().end());
    }
    for (const auto& piece : f.pieces) {
      const Polygon of_f = in_plane(axes, piece);
      for (const auto& clip : of_g) add_common(growing, f, g, axes, of_f, clip, tolerance_);
    }
    StoneJoint& joint = growing.joint;
    if (joint.pieces.empty()) return;
    if (2 * joint.area / growing.around < width_) {
      ++found_.slivers;
      found_.sliver_area += joint.area;
      return;
    }
    joint.stone = stones;
    joint.facet = facets;
    joint.normal = axes.normal;
    found_.joints.push_back(std::move(joint));
  }

  const std::vector<FacetedStone>& stones_;
  double width_, tolerance_;
  StoneJoints found_;
};

}  // namespace

double StoneJoints::area() const {
  double sum = 0;
  for (const auto& joint : joints) sum += joint.area;
  return sum;
}

StoneJoints find_joints(const std::vector<FacetedStone>& stones, double tolerance) {
  return find_joints(stones, tolerance, tolerance);
}

StoneJoints find_joints(const std::vector<FacetedStone>& stones, double width, double reach) {
  return Search(stones, width, reach).run();
}

std::vector<JointCount> count_joints(const std::vector<StoneSurface>& stones, double tolerance) {
  std::vector<JointCount> counts;
  for (const double part : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    const auto found = find_joints(facets_of(stones, part * tolerance), part * tolerance);
    counts.push_back({part * tolerance, static_cast<int>(found.joints.size()), found.area()});
  }
  return counts;
}

double tolerance_on_plateau(const std::vector<JointCount>& counts) {
  std::size_t best = 0, length = 1;
  for (std::size_t first = 0; first < counts.size(); ++first) {
    std::size_t end = first + 1;
    while (end < counts.size() && counts[end].joints == counts[first].joints && counts[first].joints > 0 &&
           std::abs(counts[end].area - counts[first].area) <= 1e-3 * counts[first].area)
      ++end;
    if (end - first > length) best = first, length = end - first;
  }
  return length > 1 ? counts[best + length / 2].tolerance : 0;
}

}  // namespace voussoir
