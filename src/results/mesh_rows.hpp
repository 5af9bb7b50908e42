// The blocks of a rank as fields.h5 has them.
#pragma once

#include "blocks/structure.hpp"
#include "output/fields_file.hpp"

namespace voussoir {

/// Collective.
/// @param held  1 for components that a support holds [dim x local node copies]
template <int dim>
MeshRows mesh_rows(const BlockSource<dim>&, const Structure<dim>&, const std::vector<char>& held);

}  // namespace voussoir
