// Stiffness and load of one cell: P1 triangles and Q1 quadrilaterals.
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapters 4, 6 and 9.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Shape functions and their gradients at one quadrature point of a cell.
struct ShapeValues {
  double weight = 0;                    ///< [m2] quadrature weight times Jacobian
  std::array<double, 4> value{};        ///< [-]
  std::array<Vector<2>, 4> gradient{};  ///< [1/m]
};

/// Quadrature points of a cell: one for a triangle, 2 x 2 Gauss points for a quadrilateral.
/// @param x positions of the cell's nodes [m]
std::vector<ShapeValues> shape_values(const Cell& cell, const std::array<Vector<2>, 4>& x);

/// Stiffness of a cell, row-major [2 count x 2 count], rows node by node [N/m].
std::vector<double> element_stiffness(const Cell& cell, const std::array<Vector<2>, 4>& x, const Material&, Plane,
                                      double thickness);

/// Integrals of products of shape functions over the cell, times thickness, row-major [count x count, m3]: times the
/// density they are the consistent mass of one component.
std::vector<double> element_products(const Cell& cell, const std::array<Vector<2>, 4>& x, double thickness);

/// Integral of each shape function over the cell, times thickness [m3].
std::array<double, 4> element_volumes(const Cell& cell, const std::array<Vector<2>, 4>& x, double thickness);

/// Mean stress of a cell (xx, yy, xy) [Pa] from the displacements of its nodes [m].
std::array<double, 3> element_stress(const Cell& cell, const std::array<Vector<2>, 4>& x,
                                     const std::array<Vector<2>, 4>& displacement, const Material&, Plane);

}  // namespace voussoir
