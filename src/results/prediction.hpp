// What a run would cost, from counts alone.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Builds blocks and joints (no solver), counts them and says what to expect. Collective.
template <int dim>
void predict(const Scene&, const BlockSource<dim>&, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

}  // namespace voussoir
