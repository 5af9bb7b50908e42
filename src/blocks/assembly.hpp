// Matrices of one block from its cells.
#pragma once

#include <vector>

#include "blocks/material.hpp"
#include "linalg/local_csr.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Positions of a cell's nodes [m].
std::array<Vector<2>, 4> cell_positions(const Block<2>&, const Cell&);

/// Stiffness of a block [N/m], rows 2 node + component.
LocalCsr block_stiffness(const Block<2>&, const Material&, Plane, double thickness);

/// Mass of a block [kg], in the rows and columns of its stiffness.
LocalCsr block_mass(const Block<2>&, double density, double thickness, Mass);

/// factor_a a + factor_b b of two matrices with the same rows and columns.
LocalCsr sum(double factor_a, const LocalCsr& a, double factor_b, const LocalCsr& b);

/// Volume that each node of a block stands for [m3].
std::vector<double> nodal_volumes(const Block<2>&, double thickness);

}  // namespace voussoir
