// Blocks from a file of gmsh: every surface is a block, physical groups are sets.
#pragma once

#include <Teuchos_Comm.hpp>
#include <memory>

#include "mesh/geo_commands.hpp"
#include "mesh/mesh.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// Meshes a .geo, or reads a .msh, on rank 0 and gives the blocks to every rank. Collective.
///
/// Blocks are in the order of the tags of surfaces. Physical surfaces become block sets, physical curves facet sets,
/// in the order of their tags; one without a name is called "group 7".
/// Throws InputError on every rank when the file cannot be used; what gmsh said is part of the message. gmsh works in a
/// process of its own, since it may crash on a damaged file.
/// @param trust  whether the file may do what a drawing need not: run programs, read and write files
std::unique_ptr<BlockSource<2>> read_gmsh(const GmshParameters&, const Teuchos::Comm<int>&, Trust trust = Trust::no);

}  // namespace voussoir
