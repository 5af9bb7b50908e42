// Stones as they are drawn become closed surfaces whose faces look outward, or are refused.
//
// What can be mended without a guess is mended and counted: points on each other, faces without area, faces that are
// there twice, faces turned inside. A surface that stays open is refused, for nobody knows what was meant.
#pragma once

#include "base/warning.hpp"
#include "stones/surface.hpp"

namespace voussoir {

/// What was mended in a stone.
struct Repair {
  int welded = 0;   ///< points that lay on another
  int no_area = 0;  ///< faces of less than three points
  int doubled = 0;  ///< faces over the points of another, left out
  int turned = 0;   ///< faces turned over
};

/// What keeps a surface from being closed: edges of one face, and of more than two.
struct OpenEdges {
  int open = 0, crowded = 0;
  Vector<3> place{};  ///< the middle of one of them
  bool none() const { return open == 0 && crowded == 0; }
};

struct ClosedStones {
  std::vector<StoneSurface> stones;
  std::vector<Repair> repairs;  ///< per stone
  Warnings warnings;            ///< what a user must know of it
};

/// Points are one when they are closer than this part of the stone's extent: above the rounding of float32 (6e-8), far
/// below any edge.
constexpr double same_point = 1e-6;

/// Merges points, drops faces without area and doubles of others.
/// @param within  [m] points are one too that are closer than this
Repair weld(StoneSurface&, double within = 0);
OpenEdges open_edges(const StoneSurface&);
/// Turns faces until neighbours agree and each shell holds a positive volume; returns how many were turned.
int turn_outward(StoneSurface&);
/// The shells of a stone (faces joined by edges), each with points of its own.
std::vector<StoneSurface> shells_of(const StoneSurface&);

/// Mends every stone; one of several shells becomes several stones. Throws InputError for stones that stay open, hold
/// no volume, have edges of more than two faces, or one closed surface within another, the first five of them.
/// @param within  [m] how far the corners of a stone that is open else may be from each other; 0 = same_point alone
ClosedStones closed(const std::vector<StoneSurface>&, double within = 0);

}  // namespace voussoir
