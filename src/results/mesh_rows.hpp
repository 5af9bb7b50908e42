// The blocks of a rank as fields.h5 has them.
#pragma once

#include "blocks/held.hpp"
#include "blocks/structure.hpp"
#include "output/fields_file.hpp"

namespace voussoir {

/// Collective.
template <int dim>
MeshRows mesh_rows(const BlockSource<dim>&, const Structure<dim>&, const Held& held);

}  // namespace voussoir
