// The convex hull of places of the plane, and the least rectangle around them.
#pragma once

#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Numbers of its corners, counter-clockwise, each once; at each it turns to the left by more than round-off.
/// @param off  [m] what is nearer to a straight line, or to another place, is on it
std::vector<int> convex_hull(const std::vector<Vector<2>>& places, double off);

struct Rectangle {
  Vector<2> along{1, 0};  ///< unit, of its longer sides
  Vector<2> length{};     ///< [m] along them and across

  double area() const { return length[0] * length[1]; }
};

/// The rectangle of least area around places: one of its sides lies on a side of their hull (H. Freeman, R. Shapira,
/// Commun. ACM 18 (1975) 409-413). Of equals the one along the first axis, or next to it.
/// @param round_off  of the extent of the places
Rectangle least_rectangle(const std::vector<Vector<2>>& places, double round_off);

}  // namespace voussoir
