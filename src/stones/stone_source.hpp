// Blocks from a file of stones, on every rank.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>

#include "mesh/geo_commands.hpp"
#include "mesh/mesh.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

/// Reads the file and finds joints on rank 0, and has the ranks mesh the stones, each those it reads by number. All
/// have the report of what was found, made and mended. Volumes of gmsh keep their cells where stones touch node to node
/// and nothing else is asked for; else they are meshed anew. Collective; throws InputError on every rank alike.
/// @param trust  whether a .geo may do what a drawing need not
std::unique_ptr<BlockSource<3>> read_stone_blocks(const StonesParameters&, const Teuchos::Comm<int>&,
                                                  Trust trust = Trust::no);

}  // namespace voussoir
