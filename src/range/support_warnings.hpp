// Supports that hold the same and do not move alike, or that hold too little.
#pragma once

#include "base/warning.hpp"
#include "model/model.hpp"

namespace voussoir {

struct Scene;

/// Nodes of two supports of which a settlement moves one; a structure that is free to move as one. The same on every
/// rank. Collective.
Warnings support_warnings(const Scene&, const Model&);

}  // namespace voussoir
