// The blocks a scene asks for, wherever they come from.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>

#include "mesh/geo_commands.hpp"
#include "mesh/mesh.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// Reads or generates the blocks. Collective; throws InputError on every rank alike.
/// What asks for more cells than this machine could compute with is refused before it is made.
/// @tparam dim  that of the mesh
/// A relative name of a file is taken from the current folder: the scene resolves it before.
template <int dim>
std::unique_ptr<BlockSource<dim>> make_block_source(const MeshParameters&, const Teuchos::Comm<int>&,
                                                    Trust trust = Trust::no);

}  // namespace voussoir
