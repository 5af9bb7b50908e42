// A closed surface as the body that it bounds: which places lie in it, how far they are from its surface, and where a
// line is in it. Triangles are found by a tree, so that a stone that was scanned costs little more than a box.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "mesh/box_tree.hpp"
#include "stones/surface.hpp"

namespace voussoir {

class Solid {
 public:
  /// @param stone  closed, faces outward
  explicit Solid(const StoneSurface& stone);

  const Box<3>& box() const { return box_; }
  const Places& points() const { return points_; }

  /// Whether a place lies inside. Of one that is nearer to the surface than `near` [m] either may be said.
  bool holds(const Vector<3>& place, double near) const;
  /// [m] from a place to the surface, if it is less than `most`; else `most`.
  double distance(const Vector<3>& place, double most) const;
  /// [m] how deep a place lies inside, negative outside: the distance to the surface.
  double depth(const Vector<3>& place) const;
  /// [m] between two surfaces, if it is less than `most`; else `most`.
  double distance(const Solid& other, double most) const;
  /// Where a line along an axis is inside: from and to [m] along the axis, ascending. Lines that graze edges are
  /// moved aside by up to `aside` [m]; nothing is said of one that still grazes some.
  /// @param through  any place on the line
  std::vector<std::array<double, 2>> along(int axis, const Vector<3>& through, double aside) const;

 private:
  using TriangleOfPlaces = std::array<Vector<3>, 3>;
  using Edge = std::array<Vector<3>, 2>;

  bool crossings(int axis, const Vector<3>& through, std::vector<std::pair<double, int>>& found) const;

  Places points_;
  Box<3> box_;
  std::vector<TriangleOfPlaces> triangles_;
  std::vector<Edge> edges_;
  BoxTree<3> tree_, edge_tree_;
};

/// Stones as bodies, each made when it is asked of first.
class Solids {
 public:
  /// @param stones  kept by their addresses
  explicit Solids(std::vector<const StoneSurface*> stones) : stones_(std::move(stones)), made_(stones_.size()) {}
  explicit Solids(const std::vector<StoneSurface>& stones) : made_(stones.size()) {
    for (const auto& stone : stones) stones_.push_back(&stone);
  }
  const Solid& operator[](std::size_t stone) const {
    if (!made_[stone]) made_[stone] = std::make_unique<Solid>(*stones_[stone]);
    return *made_[stone];
  }

 private:
  std::vector<const StoneSurface*> stones_;
  mutable std::vector<std::unique_ptr<const Solid>> made_;
};

}  // namespace voussoir
