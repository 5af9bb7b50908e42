// Edges between points, cut at all points that lie on them: whichever stone a point comes from, all see it.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mesh/box_tree.hpp"

namespace voussoir {

/// @tparam dim  2 for drawings in the plane, 3 in space
template <int dim>
class CutEdges {
 public:
  using Loop = std::vector<int>;

  /// @param points  of all stones, welded; kept by reference
  /// @param within  [m] a point that is as near to an edge, between its ends, lies on it
  CutEdges(const std::vector<Vector<dim>>& points, double within);

  /// The points on the way from a to b, both included: from either end the same.
  Loop way(int a, int b);

  /// A closed polygon with all points on its edges, without edges that it goes to and fro; empty when nothing is left.
  Loop around(const Loop& corners);

 private:
  Loop cut(int a, int b) const;

  const std::vector<Vector<dim>>& x_;
  double within_;
  BoxTree<dim> tree_;
  std::map<std::pair<int, int>, Loop> ways_;
};

}  // namespace voussoir
