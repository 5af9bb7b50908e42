// What the input leaves open, known before anything is computed.
#pragma once

#include "base/warning.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {

/// What scene and mesh tell: surfaces a format does not list, stones of a size no stone has, stones that touch no
/// other, supports and pressures on both sides of a joint. Local, and the same on every rank.
Warnings mesh_warnings(const Scene&, const BlockSource<2>&);

/// The same, with what joints and loads tell. The same on every rank. Collective.
Warnings input_warnings(const Scene&, const PlaneModel&);
/// Leaves those of steps: what is to be said of the input of a run that is taken up is said anew, of its scene now.
void forget_input_warnings(Warnings&);

}  // namespace voussoir
