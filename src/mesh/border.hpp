// The borders of blocks, edge by edge.
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// An edge that belongs to one cell of its block. The block lies to its left.
struct BorderEdge {
  std::array<VertexId, 2> vertices;  ///< ascending, so that both sides of a joint have the same
  BlockId block;
  std::array<int, 2> node;  ///< local numbers, counter-clockwise about the block
  bool operator<(const BorderEdge& other) const {
    return std::tie(vertices, block) < std::tie(other.vertices, other.block);
  }
};

std::array<VertexId, 2> ascending(VertexId, VertexId);

/// Border edges of all blocks, sorted: the sides of a joint follow each other.
std::vector<BorderEdge> border_edges(const std::vector<Block<2>>&);

}  // namespace voussoir
