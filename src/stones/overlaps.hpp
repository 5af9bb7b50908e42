// Stones that lie in each other, which no joint shows: where two stones overlap deeply no faces are near each other.
#pragma once

#include <vector>

#include "stones/surface.hpp"

namespace voussoir {

struct StoneOverlap {
  std::array<int, 2> stone{};
  double depth = 0;   ///< [m] of the deepest place found; at most the true depth
  Vector<3> place{};  ///< [m]
};

/// Pairs of closed stones, faces outward, that overlap by more than a depth, in the order of stones. Looked at are
/// points and edges of both between the other's faces, middles of their faces, the same a little inside (for faces that
/// lie on each other) and centres: an overlap that avoids all of these has no corner and no edge in the other stone.
std::vector<StoneOverlap> overlaps(const std::vector<StoneSurface>&, double depth);

/// [m] between two stones: from points of either to faces of the other, so where edges cross it is at most too far.
double distance_between(const StoneSurface&, const StoneSurface&);

/// [m] how deep a place lies inside of a stone, negative outside: the distance to its surface.
double depth_inside(const StoneSurface&, const Vector<3>& place);

}  // namespace voussoir
