// The mesh of a scene, made and checked before anything is computed.
#pragma once

#include <memory>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include "mesh/geo_commands.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Messages name the scene. Collective; throws InputError on every rank alike.
template <int dim>
std::unique_ptr<BlockSource<dim>> checked_blocks(const Scene&, const Teuchos::RCP<const Teuchos::Comm<int>>&,
                                                 Trust trust = Trust::no);

}  // namespace voussoir
