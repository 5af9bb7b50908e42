// Stones whose quadratic cells have no edges to bend along.
#pragma once

#include "base/warning.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

struct Scene;

/// `one_cell_between_joints`: edges on joints and supports stay straight, so a stone that has them all round and a
/// single cell between has linear cells in all but name. Each rank looks at the blocks it reads. Collective.
Warnings warnings_of_stiff_stones(const Scene&, const BlockSource<3>&, const Teuchos::Comm<int>&);

}  // namespace voussoir
