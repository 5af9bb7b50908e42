// The points two blocks have in common.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// An edge of the border of a block.
struct BorderEdge {
  VertexId low = 0, high = 0;  ///< its vertices, low < high
  int node_low = 0, node_high = 0;
  Vector<2> normal{};          ///< outward, times the length of the edge [m]
};

/// Edges that belong to one cell only, ascending by vertices.
std::vector<BorderEdge> border_edges(const Block<2>&);

struct PointOfTwoBlocks {
  VertexId vertex = 0;
  int node_i = 0, node_j = 0;  ///< node numbers within each block
  Vector<2> normal{};          ///< unit, outward of block i
  double length = 0;           ///< [m] half the length of the edges that meet here
};

/// Points of the joint between two blocks, ascending by vertex. A point where the joint turns a corner
/// of more than 20 degrees is two points, one for each side.
std::vector<PointOfTwoBlocks> points_of_joint(const std::vector<BorderEdge>& i, const std::vector<BorderEdge>& j);

}  // namespace voussoir
