// What a run would cost, from counts alone.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <ostream>

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Makes all loads where they act, and forgets them: what cannot be placed is told before a run. Collective; throws
/// InputError on every rank alike.
template <int dim>
void place_loads(const Scene&, const BlockSource<dim>&, const Teuchos::RCP<const Teuchos::Comm<int>>&);

/// Builds blocks and joints (no solver), counts them and says what to expect. Collective.
template <int dim>
void predict(const Scene&, const BlockSource<dim>&, const Teuchos::RCP<const Teuchos::Comm<int>>&, std::ostream& say);

}  // namespace voussoir
