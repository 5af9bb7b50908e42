// A cell in space over any stone: the linear tetrahedron, whose strain is uniform. What edges add is in simplex.hpp.
//
// By itself it bends by shearing alone and is the stiffest of cells: with 100 corners a stone about a tenth too stiff.
// What it gives is safe to compare with: it has no modes of its own and passes every patch test.
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapter 6.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/simplex.hpp"

namespace voussoir {

/// Row-major [12 x 12], rows node by node [N/m].
/// @param x  positions of its nodes [m], in the order of Cell
std::vector<double> tetrahedron_stiffness(const std::array<Vector<3>, 4>& x, const Material&);

/// Integral of each shape function [m3].
std::array<double, 4> tetrahedron_volumes(const std::array<Vector<3>, 4>& x);

/// Integrals of products of shape functions, row-major [4 x 4, m3].
std::vector<double> tetrahedron_products(const std::array<Vector<3>, 4>& x);

/// Stress (xx, xy, xz, yy, yz, zz) [Pa] from the displacements of its nodes [m].
std::array<double, 6> tetrahedron_stress(const std::array<Vector<3>, 4>& x,
                                         const std::array<Vector<3>, 4>& displacement, const Material&);

}  // namespace voussoir
