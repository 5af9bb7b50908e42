// Stiffness of a cell in space: the trilinear hexahedron.
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapters 6, 8 and 9.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"

namespace voussoir {

/// Row-major [24 x 24], rows node by node [N/m], by 2 x 2 x 2 Gauss points, exact for parallelepipeds.
/// @param x  positions of its nodes [m], in the order of Cell
std::vector<double> hexahedron_stiffness(const std::array<Vector<3>, 8>& x, const Material&);

/// Integral of each shape function [m3].
std::array<double, 8> hexahedron_volumes(const std::array<Vector<3>, 8>& x);

}  // namespace voussoir
