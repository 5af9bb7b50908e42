// Blocks divided by all ranks together, where no rank has room for the graph of all.
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// By PT-Scotch, with shared vertices as weights of edges. Depends on the arguments and the ranks that have the rows
/// alone; a rank may be left without blocks. Collective; throws on every rank what fails on any.
/// @param rows            of the blocks this rank reads, numbered on from rank to rank
/// @param vertex_weights  [-] of these, > 0
/// @return of these blocks the ranks that own them
std::vector<int> divided_by_all(const BlockGraph& rows, const std::vector<double>& vertex_weights,
                                const Teuchos::Comm<int>&);

}  // namespace voussoir
