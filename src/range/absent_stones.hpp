// What a scene asks of stones that are not there.
#pragma once

#include "base/warning.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {

/// Loads and settlements that act on stones which have gone or not appeared yet, and places observed there. Weight and
/// its kind act on the stones that are there, whichever they are. Collective.
Warnings warnings_of_absent_stones(const Scene&, const PlaneModel&);

}  // namespace voussoir
