// The geometry of a model, for kernels that are templates of the dimension: who has to know it asks Model::in_geometry.
#pragma once

#include <variant>

#include "blocks/structure.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

template <int dim>
struct Geometry {
  const BlockSource<dim>& source;
  const Structure<dim>& structure;
};

using AnyGeometry = std::variant<Geometry<2>, Geometry<3>>;

}  // namespace voussoir
