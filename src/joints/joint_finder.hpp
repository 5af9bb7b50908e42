// The points two blocks have in common.
#pragma once

#include <vector>

#include "mesh/border.hpp"

namespace voussoir {

struct PointOfTwoBlocks {
  VertexId vertex = 0;
  int node_i = 0, node_j = 0;  ///< node numbers within each block
  Vector<2> normal{};          ///< unit, outward of block i
  double length = 0;           ///< [m] half the length of the edges that meet here
};

/// Points of the joint between two blocks, ascending by vertex. A point where the joint turns a corner
/// of more than 20 degrees is two points, one for each side.
/// @param border_i, border_j  border_facets() of each block alone
std::vector<PointOfTwoBlocks> points_of_joint(const Block<2>& i, const std::vector<BorderEdge>& border_i,
                                              const Block<2>& j, const std::vector<BorderEdge>& border_j);

}  // namespace voussoir
