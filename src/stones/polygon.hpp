// Polygons in a plane: what two have in common, where their corners are, how they are cut into triangles.
#pragma once

#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Corners one after the other, counter-clockwise unless said.
using Polygon = std::vector<Vector<2>>;

/// [m2] positive when counter-clockwise.
double area(const Polygon&);
double perimeter(const Polygon&);

/// [m] of a strip of the same area and perimeter that is much longer than wide.
double mean_width(const Polygon&);

/// @param slack  sine of the angle by which a corner may point inward
bool is_convex(const Polygon&, double slack);

/// Whether a point lies inside: odd numbers of edges lie to its right.
bool holds(const Polygon&, const Vector<2>&);

/// A border that comes to a place again touches itself there: the corners, by number, of loops that do not, each from
/// where it touches on. One loop where it touches itself nowhere.
std::vector<std::vector<int>> loops_apart(const Polygon&);

/// What is common to a convex polygon and a convex one that clips it; fewer than three corners when nothing is.
///
/// Theory  I. E. Sutherland, G. W. Hodgman, Commun. ACM 17 (1974) 32-42.
Polygon common_part(Polygon, const Polygon& clip);

/// Corners left when those closer than `within` are one and those as near to the line of their neighbours are none.
Polygon corners_of(const Polygon&, double within);

/// Triangles over the corners of a polygon that may be out of plane, ears of the shortest diagonal first and, of
/// diagonals of one length, by their places: the same cut whichever side the polygon is seen from.
std::vector<std::array<int, 3>> cut_into_triangles(const std::vector<Vector<3>>& polygon);

/// Axes of a plane that make a right-handed system with its normal.
struct PlaneAxes {
  Vector<3> origin, first, second, normal;
  PlaneAxes(const Vector<3>& at, const Vector<3>& along_normal);
  Vector<2> operator()(const Vector<3>& x) const { return {dot(x - origin, first), dot(x - origin, second)}; }
  Vector<3> place(const Vector<2>& p) const { return origin + p[0] * first + p[1] * second; }
};

}  // namespace voussoir
