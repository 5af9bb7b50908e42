// Blocks on their way from the rank that has read them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// A block, the names of its sets and what it touches: all that a source tells of it.
template <int dim>
struct BlockToSend {
  Block<dim> block;
  std::vector<std::string> set_names;  ///< per set of the block
  std::vector<Neighbour> neighbours;

  BlockToSend() = default;
  /// @param names  of its sets, among others
  BlockToSend(Block<dim> block_, const SetNames& names, std::vector<Neighbour> neighbours_ = {})
      : block(std::move(block_)), neighbours(std::move(neighbours_)) {
    for (const int set : block.sets) set_names.push_back(names[set]);
  }
  void teach(SetNames& names) const {
    for (std::size_t k = 0; k < set_names.size(); ++k) names.learn(block.sets[k], set_names[k]);
  }
};

template <int dim>
std::string bytes_of(const std::vector<BlockToSend<dim>>&);
template <int dim>
std::vector<BlockToSend<dim>> blocks_of_bytes(const std::string&);

}  // namespace voussoir
