// Matrices of one block from its cells.
#pragma once

#include <vector>

#include "blocks/material.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Positions of a cell's nodes [m]; those that a cell does not have are 0.
std::array<Vector<2>, 4> cell_positions(const Block<2>&, const Cell&);
std::array<Vector<3>, 8> cell_positions(const Block<3>&, const Cell&);

/// Stiffness of a block [N/m], rows dim node + component.
LocalCsr block_stiffness(const Block<2>&, const Material&, Plane, double thickness);
LocalCsr block_stiffness(const Block<3>&, const Material&, Hexahedra);

/// The same, as a model has its blocks.
template <int dim>
LocalCsr block_stiffness(const Block<dim>& block, const Material& material, const ModelParameters& model) {
  if constexpr (dim == 2)
    return block_stiffness(block, material, model.plane, thickness_of(material, model));
  else
    return block_stiffness(block, material, model.hexahedra);
}

/// Mass of a block [kg], in the rows and columns of its stiffness.
LocalCsr block_mass(const Block<2>&, double density, double thickness, Mass);
LocalCsr block_mass(const Block<3>&, double density, Mass);
template <int dim>
LocalCsr block_mass(const Block<dim>& block, const Material& material, const ModelParameters& model, Mass kind) {
  if constexpr (dim == 2)
    return block_mass(block, material.density, thickness_of(material, model), kind);
  else
    return block_mass(block, material.density, kind);
}

/// factor_a a + factor_b b of two matrices; b has no entry where a has none.
LocalCsr sum(double factor_a, const LocalCsr& a, double factor_b, const LocalCsr& b);

/// Of each node the side of the cube that is as large as the cells beside it are in the mean [m].
std::vector<double> cell_sizes(const Block<3>&);

/// Volume that each node of a block stands for [m3].
std::vector<double> nodal_volumes(const Block<2>&, double thickness);
std::vector<double> nodal_volumes(const Block<3>&);
template <int dim>
std::vector<double> nodal_volumes(const Block<dim>& block, const Material& material, const ModelParameters& model) {
  if constexpr (dim == 2)
    return nodal_volumes(block, thickness_of(material, model));
  else
    return nodal_volumes(block);
}

}  // namespace voussoir
