// A cell in space: the trilinear hexahedron, to which three modes are added for bending.
//
// Trilinear cells can bend only by shearing, so a stone that is one cell thick is too stiff by half and more. The modes
// 1 - xi^2, 1 - eta^2, 1 - zeta^2 of each component (E. L. Wilson) let it bend. They are unknowns of the cell alone,
// which condensation takes out, and need not agree with those of its neighbours; with the gradients of R. L. Taylor
// uniform strain is exact in distorted cells too.
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapters 6, 8 and 9;
//         R. L. Taylor, P. J. Beresford, E. L. Wilson, Int. J. Numer. Methods Eng. 10 (1976) 1211-1219.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"

namespace voussoir {

/// Row-major [24 x 24], rows node by node [N/m], by 2 x 2 x 2 Gauss points, exact for parallelepipeds.
/// @param x  positions of its nodes [m], in the order of Cell
std::vector<double> hexahedron_stiffness(const std::array<Vector<3>, 8>& x, const Material&, Hexahedra);

/// Integral of each shape function [m3].
std::array<double, 8> hexahedron_volumes(const std::array<Vector<3>, 8>& x);

/// Integrals of products of shape functions, row-major [8 x 8, m3].
std::vector<double> hexahedron_products(const std::array<Vector<3>, 8>& x);

/// Mean stress (xx, xy, xz, yy, yz, zz) [Pa] from the displacements of its nodes [m]. The modes add nothing to a mean.
std::array<double, 6> hexahedron_stress(const std::array<Vector<3>, 8>& x, const std::array<Vector<3>, 8>& displacement,
                                        const Material&);

}  // namespace voussoir
