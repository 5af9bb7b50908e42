// Blocks that are kept in memory: what is made of a file, and what tests put together by hand.
#pragma once

#include <memory>

#include "mesh/mesh.hpp"

namespace voussoir {

/// Blocks and the names their sets refer to.
template <int dim>
struct BlockList {
  std::vector<Block<dim>> blocks;  ///< block b has id b
  SetNames block_sets;             ///< of these blocks
  std::vector<std::string> facet_sets;
  bool quadratic = false;           ///< simplices bend along edges that one block alone has
  Warnings warnings;                ///< of the source
  std::vector<std::string> report;  ///< of the source
  std::string picture;              ///< of the source, on the first rank alone
};

/// A source that hands out the blocks of a list which is the same on every rank.
template <int dim>
std::unique_ptr<BlockSource<dim>> make_source(BlockList<dim>);

/// The graph of blocks that share vertices, from the vertices of each block.
BlockGraph graph_of_shared_vertices(const std::vector<std::vector<VertexId>>& vertices_of_block);

}  // namespace voussoir
