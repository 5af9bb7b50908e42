// Forces on blocks: what a load brings to their nodes, and to those of their edges that bend.
//
// A traction t comes to corner i as the integral of L_i t, and to an edge ij that bends as that of 4 L_i L_j t. Edges
// hand theirs over to the corners of their block (condensed_edges.hpp), so what is solved knows nodes alone; stresses
// and energies ask for the forces of edges again, for by them edges bend.
#pragma once

#include <vector>

#include "blocks/block_system.hpp"

namespace voussoir {

struct BlockForces {
  std::vector<double> of_nodes;  ///< [N, components x local node copies]
  std::vector<double> of_edges;  ///< [N, components x local edges that bend]

  BlockForces() = default;
  /// None, on all of a structure.
  explicit BlockForces(const BlockSystem& s)
      : of_nodes(s.components() * static_cast<std::size_t>(s.nodes()), 0.0),
        of_edges(s.components() * static_cast<std::size_t>(s.edges()), 0.0) {}
};

/// Forces of nodes with what edges hand over to them, which has neither a sum nor a moment.
std::vector<double> handed_over(const BlockSystem&, BlockForces);

/// Of the forces of all local edges that bend, or of none where the list is empty, those of a block.
std::vector<double> forces_of_edges(const BlockSystem&, int block, const std::vector<double>& of_all);

}  // namespace voussoir
