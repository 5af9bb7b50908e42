// A drawing of stones as blocks on every rank.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>

#include "mesh/mesh.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

/// Reads a drawing on rank 0, fits its stones together, meshes them and gives the blocks to every rank. Collective;
/// throws InputError on every rank alike.
std::unique_ptr<BlockSource<2>> read_drawn_blocks(const StonesParameters&, const Teuchos::Comm<int>&);

}  // namespace voussoir
