// Blocks of a file that are drawn alike become equal to the last bit, so that they have one stiffness.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/translates.hpp"

namespace voussoir {

/// Gives blocks that are translates of each other, but for round-off of the drawing, the nodes and cells of the first
/// of them, in its order, each at a base of its own. Bases and what is around them are rounded so that sums are exact:
/// differences of positions within blocks that are alike are equal to the last bit, as blocks/shapes.hpp asks.
/// Copies of a vertex in such blocks may lie apart by that round-off, 1e-13 of the largest coordinate: what they are is
/// told by vertices, never by places. Facets, folds and sets are those of the block itself, as are curved edges, which
/// are found later. Blocks without cells are left alone.
/// @param largest  [m] coordinate of the drawing
/// @return how many shapes there are
int make_alike_equal(std::vector<Block<3>>&, double largest);

/// What it does to the first block of a shape: places around its first node, on the grid of the drawing.
void round_places(Block<3>&, const DrawnNumbers&);

/// What it does to another one.
/// @param first  of its shape, its places rounded
/// @param order  per node of the first one its own
void take_shape(const Block<3>& first, const std::vector<int>& order, const DrawnNumbers&, Block<3>&);

}  // namespace voussoir
