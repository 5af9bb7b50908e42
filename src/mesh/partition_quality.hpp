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

/// @param owner  rank of each block
/// @param work   of each block, as the partition was given it
PartitionQuality partition_quality(const BlockGraph&, const std::vector<int>& owner, const std::vector<double>& work,
                                   int ranks);

/// Largest of all ranks over the mean; 1 where there is nothing. Collective.
double imbalance(const Teuchos::Comm<int>&, long long mine);

}  // namespace voussoir
