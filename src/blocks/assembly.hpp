// Matrices of one block from its cells.
#pragma once

#include <vector>

#include "blocks/material.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Positions of a cell's nodes [m].
std::array<Vector<2>, 4> cell_positions(const Block<2>&, const Cell&);

/// Stiffness of a block [N/m], rows dim node + component.
LocalCsr block_stiffness(const Block<2>&, const Material&, Plane, double thickness);
LocalCsr block_stiffness(const Block<3>&, const Material&);

/// The same, as the model has blocks of the plane.
template <int dim>
LocalCsr block_stiffness(const Block<dim>& block, const Material& material, const ModelParameters& model) {
  if constexpr (dim == 2)
    return block_stiffness(block, material, model.plane, model.thickness);
  else
    return block_stiffness(block, material);
}

/// Mass of a block [kg], in the rows and columns of its stiffness.
LocalCsr block_mass(const Block<2>&, double density, double thickness, Mass);

/// factor_a a + factor_b b of two matrices with the same rows and columns.
LocalCsr sum(double factor_a, const LocalCsr& a, double factor_b, const LocalCsr& b);

/// Volume that each node of a block stands for [m3].
std::vector<double> nodal_volumes(const Block<2>&, double thickness);
std::vector<double> nodal_volumes(const Block<3>&);

}  // namespace voussoir
