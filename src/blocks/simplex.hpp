// The simplest cells, triangles in the plane and tetrahedra in space: linear functions, and what edges add that bend.
//
// Corners have the shape functions L_i, of uniform gradient. With the function 4 L_i L_j of every edge a cell is the
// quadratic one: corners keep their functions, so an edge that stays straight is one whose function is left out
// (condensed_edges.hpp). In d dimensions, of a cell of measure V,
//
//   integral of L_a L_b = V (1 + [a = b]) / ((d + 1) (d + 2))
//   mean of grad 4 L_i L_j = 4 / (d + 1) (grad L_i + grad L_j)
//
// Theory  O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, chapters 6 and 8.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "blocks/material.hpp"

namespace voussoir {

/// Lame's constants of a solid; those by which a sheet bears in its plane.
struct Lame {
  double lambda = 0, mu = 0;  ///< [Pa]
};
Lame lame(const Material&);
Lame lame(const Material&, Plane);

/// Energy of two gradients, component i of displacement along a and j along b [Pa/m2].
template <int dim>
double coupled(const Lame& m, const Vector<dim>& a, const Vector<dim>& b, int i, int j) {
  return m.lambda * a[i] * b[j] + m.mu * (a[j] * b[i] + (i == j ? dot(a, b) : 0));
}

template <int dim>
struct Simplex {
  static constexpr int corners = dim + 1, edges = dim * (dim + 1) / 2;
  using Places = std::array<Vector<dim>, corners>;
  /// How far every component moves along every axis: slope[c][d] of component c by place d.
  using Slope = std::array<Vector<dim>, dim>;
  using OfEdges = std::array<Vector<dim>, edges>;

  /// @param x  of its corners [m], in the order of Cell
  explicit Simplex(const Places& x);

  double measure = 0;  ///< [m2], in space [m3]
  Places gradient{};   ///< [1/m] of the shape functions
};

/// Stress of a slope [Pa]: (xx, xy, xz, yy, yz, zz), in the plane (xx, yy, xy).
std::array<double, 6> stress_of(const Lame&, const Simplex<3>::Slope&);
std::array<double, 3> stress_of(const Lame&, const Simplex<2>::Slope&);

/// Corners of the edges of a cell; matrices of edges are in this order. A triangle has the first three.
constexpr std::array<std::array<int, 2>, 6> simplex_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

/// Stiffness that the functions of edges add, row-major, rows edge by edge.
struct EdgeStiffness {
  std::vector<double> with_corners;  ///< [dim edges x dim corners]
  std::vector<double> with_edges;    ///< [dim edges, squared]
};
template <int dim>
EdgeStiffness edge_stiffness(const Simplex<dim>&, const Lame&);

/// Integral of the function of an edge, the same for all of them.
template <int dim>
double edge_volume(const Simplex<dim>& cell) {
  return 4 * cell.measure / ((dim + 1) * (dim + 2));
}

/// Mean over the cell of the slope that its edges add. @param amount  of the function of each edge [m]
template <int dim>
typename Simplex<dim>::Slope edge_slope(const Simplex<dim>&, const typename Simplex<dim>::OfEdges& amount);

}  // namespace voussoir
