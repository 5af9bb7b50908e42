// What a scene asks of stones that are not there.
#pragma once

#include "base/warning.hpp"
#include "model/model.hpp"

namespace voussoir {

struct Scene;

/// Loads and settlements that act on stones which have gone or not appeared yet, and places observed there. Weight and
/// its kind act on the stones that are there, whichever they are. Collective.
Warnings warnings_of_absent_stones(const Scene&, const Model&);

}  // namespace voussoir
