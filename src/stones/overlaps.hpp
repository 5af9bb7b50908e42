// Stones that lie in each other, which no joint shows: where two stones overlap deeply no faces are near each other.
#pragma once

#include <vector>

#include "stones/surface.hpp"

namespace voussoir {

struct StoneOverlap {
  std::array<int, 2> stone{};
  double depth = 0;   ///< [m] of the deepest place found; at most the true depth
  Vector<3> place{};  ///< [m]
  /// [m] what chords of round faces at the place may lie in each other by: the heights of the arcs over those of both
  /// stones. Zero where faces there turn from one to the next as round ones do not.
  double of_chords = 0;
};

/// Pairs of closed stones, faces outward, that overlap by more than a depth, in the order of stones. Looked at are
/// corners of both, and lines along all axes through what their boxes have in common: how long each is in both.
std::vector<StoneOverlap> overlaps(const std::vector<StoneSurface>&, double depth);

}  // namespace voussoir
