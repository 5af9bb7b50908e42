// A drawing in a plane: straight edges between points, and the cells that they enclose.
#pragma once

#include <vector>

#include "stones/polygon.hpp"

namespace voussoir {

/// Edges meet only at their ends, and no edge is there twice.
struct Drawing2 {
  Polygon points;
  std::vector<std::array<int, 2>> edges;
};

/// A connected part of the plane without edges in it, to the left of all its loops.
struct DrawnCell {
  std::vector<int> outer;               ///< numbers of points, counter-clockwise; a point may come twice
  std::vector<std::vector<int>> holes;  ///< clockwise
  double area = 0;                      ///< [m2] without holes
  Vector<2> inside{};                   ///< a point of it, far from its edges
};

/// The bounded cells. Edges that hang free, with the same cell on both sides, are left out.
std::vector<DrawnCell> cells_of(Drawing2);

/// A point between loops, far from them: the middle of the widest span that horizontal lines between corners have
/// inside, where inside is what lies in an odd number of loops.
Vector<2> point_inside(const std::vector<Polygon>& loops);

/// Pairs of edges that cross between their ends, which a drawing must not have, in ascending order.
std::vector<std::array<int, 2>> crossings_of(const Drawing2&);

/// How often directed edges go around a point, counter-clockwise.
int winding(const Polygon& points, const std::vector<std::array<int, 2>>& edges, const Vector<2>& at);

}  // namespace voussoir
