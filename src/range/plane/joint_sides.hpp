// Supports and loads on a curve between two stones: the curve has two sides, one on either stone.
//
// A support that holds both sides glues the stones. A load whose forces point one way acts on both stones, twice as
// large as it says: that is no question but an error. A pressure pushes the stones apart and is in balance: right for
// water in a crack or a flat jack, wrong for all else.
#pragma once

#include "base/warning.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Throws InputError for a load that would act on both sides of a joint and twice, and for a side (`blocks`) that no
/// facet of the set is on. Local, and the same on every rank.
void check_sides(const Scene&, const BlockSource<2>&);

/// Supports that hold, and pressures that act on, both sides of joints without saying that both are meant
/// (`blocks` = all). Local, and the same on every rank.
Warnings warnings_of_sides(const Scene&, const BlockSource<2>&);

}  // namespace voussoir
