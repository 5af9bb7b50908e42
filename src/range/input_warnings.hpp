// What the input leaves open, known before anything is computed.
#pragma once

#include "base/warning.hpp"
#include "mesh/mesh.hpp"
#include "model/model.hpp"

namespace voussoir {

/// What scene and mesh tell: surfaces a format does not list, stones of a size no stone has, stones that touch no
/// other, in the plane supports and pressures on both sides of a joint. The same on every rank. Collective.
template <int dim>
Warnings mesh_warnings(const Scene&, const BlockSource<dim>&, const Teuchos::Comm<int>&);

/// The same, with what joints and loads tell. The same on every rank. Collective.
Warnings input_warnings(const Scene&, const Model&);

/// Those of them that hold of rigid stones too, all of whose joints may open and slide: none of cells, of bonds or of
/// energies. Collective.
Warnings warnings_of_rigid_stones(const Scene&, const Model&);

/// Leaves those of steps: what is to be said of the input of a run that is taken up is said anew, of its scene now.
void forget_input_warnings(Warnings&);

}  // namespace voussoir
