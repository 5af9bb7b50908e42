// Stiffness and load of one cell in space, a hexahedron or a tetrahedron by its number of nodes.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Row-major [3 count x 3 count], rows node by node [N/m].
/// @param x  positions of the cell's nodes [m], those of a tetrahedron first
std::vector<double> solid_stiffness(const Cell&, const std::array<Vector<3>, 8>& x, const Material&, Hexahedra);

/// Integral of each shape function [m3].
std::array<double, 8> solid_volumes(const Cell&, const std::array<Vector<3>, 8>& x);

/// Integrals of products of shape functions, row-major [count x count, m3].
std::vector<double> solid_products(const Cell&, const std::array<Vector<3>, 8>& x);

/// Mean stress (xx, xy, xz, yy, yz, zz) [Pa] from the displacements of its nodes [m].
std::array<double, 6> solid_stress(const Cell&, const std::array<Vector<3>, 8>& x,
                                   const std::array<Vector<3>, 8>& displacement, const Material&);

}  // namespace voussoir
