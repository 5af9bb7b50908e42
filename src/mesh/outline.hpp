// The outline of a block wherever it has moved to, and how deep two of them lie in each other.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// A border edge with its places [m]; the block lies to its left.
struct OutlineEdge {
  Vector<2> from{}, to{};
};

/// Border edges of a block in any order, those of holes included.
using Outline = std::vector<OutlineEdge>;

/// Pairs of local nodes of a block, one for each border edge, counter-clockwise about the block.
std::vector<std::array<int, 2>> border_of(const std::vector<Cell>&);

/// The shortest side of the cells of a block [m].
/// @param position  of the block's nodes
double shortest_side(const std::vector<Cell>&, const Vector<2>* position);

/// Whether a place lies within an outline. On the border itself either answer may come.
bool inside(const Outline&, const Vector<2>&);

/// Distance of a place from the nearest border edge [m], within the outline or without.
double distance_to_border(const Outline&, const Vector<2>&);

/// How far one of two blocks has to be moved, along the normal of an edge of either, until neither holds a node of the
/// border of the other or a middle between two of them [m]; 0 where none does.
/// @param tolerance  [m] places so close to the border of the other are not in it
double overlap_depth(const Outline&, const Outline&, double tolerance);

/// A face with the edges of other borders that go on in its line from either end, one after the other: they look the
/// same way, and where two follow each other there is neither a step nor a gap that matters to cells of a length.
/// @param cell  [m]
Outline with_what_goes_on_flush(const Outline& face, const Outline& others, double cell);

}  // namespace voussoir
