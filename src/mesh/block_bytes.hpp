// Blocks on their way from the rank that has read them.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// A block and what it touches: all that a source tells of it.
template <int dim>
struct BlockWithNeighbours {
  Block<dim> block;
  std::vector<Neighbour> neighbours;
};

template <int dim>
std::string bytes_of(const std::vector<BlockWithNeighbours<dim>>&);
template <int dim>
std::vector<BlockWithNeighbours<dim>> blocks_of_bytes(const std::string&);

}  // namespace voussoir
