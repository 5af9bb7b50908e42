// Supports and loads on a curve between two stones, in space on a surface: it has two sides, one on either stone.
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
/// facet of the set is on. Every rank throws, or none. Collective.
template <int dim>
void check_sides(const Scene&, const BlockSource<dim>&, const Teuchos::Comm<int>&);

/// Supports that hold, and pressures that act on, both sides of joints without saying that both are meant
/// (`blocks` = all; in space also `faces` of blocks that are named, by which stones are held whole). Collective.
template <int dim>
Warnings warnings_of_sides(const Scene&, const BlockSource<dim>&, const Teuchos::Comm<int>&);

}  // namespace voussoir
