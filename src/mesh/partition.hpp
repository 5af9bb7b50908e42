// Which rank owns which block: few joints cut, equal work.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// Rank of each block, by METIS k-way with the number of shared vertices as weight of an edge.
/// The answer depends on the arguments alone. Every rank gets a block if there are enough; with more ranks than
/// blocks the last ones stay empty. Parts of up to four ranks are connected where the graph is.
///
/// @param vertex_weights  [-] work per block, > 0: its unknowns
std::vector<int> partition(const BlockGraph&, const std::vector<double>& vertex_weights, int ranks);

/// The same for as many ranks as the communicator has: found on rank 0, equal on all. Collective.
std::vector<int> partition(const BlockGraph&, const std::vector<double>& vertex_weights, const Teuchos::Comm<int>&);

}  // namespace voussoir
