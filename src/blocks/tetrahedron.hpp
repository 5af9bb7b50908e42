// A cell in space over any stone: the linear tetrahedron, whose strain is uniform, and what its edges add to it.
//
// By itself it bends by shearing alone and is the stiffest of cells: with 100 corners a stone about a tenth too stiff.
// What it gives is safe to compare with: it has no modes of its own and passes every patch test. With the function
// 4 L_i L_j of every edge it is the quadratic tetrahedron: corners keep their shape functions L_i, so an edge that
// stays straight is one whose function is left out (condensed_edges.hpp).
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapters 6 and 8.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"

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

/// Corners of its edges; matrices of edges are in this order.
constexpr std::array<std::array<int, 2>, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

/// Stiffness that the functions of edges add, row-major, rows edge by edge [N/m].
struct EdgeStiffness {
  std::vector<double> with_corners;  ///< [18 x 12]
  std::vector<double> with_edges;    ///< [18 x 18]
};
EdgeStiffness tetrahedron_edge_stiffness(const std::array<Vector<3>, 4>& x, const Material&);

/// Integral of the function of an edge [m3], the same for all of them.
double tetrahedron_edge_volume(const std::array<Vector<3>, 4>& x);

/// Mean over the cell of the stress that its edges add [Pa]. @param amount  of the function of each edge [m]
std::array<double, 6> tetrahedron_edge_stress(const std::array<Vector<3>, 4>& x, const std::array<Vector<3>, 6>& amount,
                                              const Material&);

}  // namespace voussoir
