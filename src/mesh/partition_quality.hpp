// How well blocks are shared out among ranks.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

struct PartitionQuality {
  double cut = 0;        ///< [-] share of vertices common to two blocks whose blocks have different owners
  double imbalance = 1;  ///< [-] largest work of a rank over the mean
  int neighbours = 0;    ///< ranks whose blocks share a vertex with those of one rank, the most of any rank
  double mean_neighbours = 0;
};

/// What a rank knows of that.
struct RankShare {
  double work = 0;      ///< of its blocks, as the partition was given it
  double vertices = 0;  ///< that its blocks share with others, block by block
  double cut = 0;       ///< of these with blocks of other ranks
  int neighbours = 0;   ///< these ranks
};

/// @param shares  of every rank
PartitionQuality partition_quality(const std::vector<RankShare>& shares);

/// Largest of all ranks over the mean; 1 where there is nothing. Collective.
double imbalance(const Teuchos::Comm<int>&, long long mine);

}  // namespace voussoir
