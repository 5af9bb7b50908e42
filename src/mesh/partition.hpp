// Which rank owns which block: few joints cut, equal work.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

struct PartitionSettings {
  /// Blocks up to which the first rank divides them for all, by METIS. Their graph takes some 80 bytes a block there,
  /// less with a million than the libraries of a process, and METIS 2 s; PT-Scotch makes less even parts (shares.md).
  long long most_on_first = 1000000;
};

/// Rank of each block, by METIS k-way with the number of shared vertices as weight of an edge.
/// The answer depends on the arguments alone. Every rank gets a block if there are enough; with more ranks than
/// blocks the last ones stay empty. Parts of up to four ranks are connected where the graph is.
///
/// @param vertex_weights  [-] work per block, > 0: its unknowns
std::vector<int> partition(const BlockGraph&, const std::vector<double>& vertex_weights, int ranks);

/// The same of a graph whose rows are on many ranks, for as many ranks as the communicator has: on the first rank if
/// there are few blocks or it has all rows, else by PT-Scotch, where parts need not be connected. Collective.
/// @param rows            of the blocks this rank reads: those of all ranks one after the other are all blocks
/// @param vertex_weights  of these
/// @param blocks          of all ranks
/// @return of these blocks
std::vector<int> partition(const BlockGraph& rows, const std::vector<double>& vertex_weights, long long blocks,
                           const Teuchos::Comm<int>&, const PartitionSettings& = {});

}  // namespace voussoir
