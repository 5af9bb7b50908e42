// What a rank has of a structure: the blocks it owns, and the halo of blocks that share a vertex with them.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/partition.hpp"

namespace voussoir {

struct BlockShare {
  std::vector<BlockId> owned, halo;  ///< ascending
  std::vector<int> owner_of_halo;    ///< rank of each block of the halo
};

/// Shares out blocks by their unknowns (partition.hpp), so that this rank can be asked of those of its share.
/// No rank hears of more than the blocks it reads, those it owns and their halo. Collective.
template <int dim>
BlockShare share_out(const BlockSource<dim>&, const Teuchos::Comm<int>&, const PartitionSettings& = {});

/// The share of a rank where the owners of all blocks are known. Local.
template <int dim>
BlockShare share_of_owners(const BlockSource<dim>&, const std::vector<int>& owner_of_block, int rank);

}  // namespace voussoir
