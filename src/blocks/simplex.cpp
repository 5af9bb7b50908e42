#include "blocks/simplex.hpp"

namespace voussoir {

Lame lame(const Material& m) {
  return {m.young_modulus * m.poisson_ratio / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio)),
          m.young_modulus / (2 * (1 + m.poisson_ratio))};
}

Lame lame(const Material& m, Plane plane) {
  const auto d = plane_elasticity(m, plane);
  return {d[0][1], d[2][2]};
}

/// Of a triangle: the normals of the sides opposite to its corners, inward, over the heights there.
template <>
Simplex<2>::Simplex(const Places& x) {
  const auto a = x[1] - x[0], b = x[2] - x[0];
  measure = cross(a, b) / 2;
  const double factor = 1 / (2 * measure);
  gradient[1] = {factor * b[1], -factor * b[0]};
  gradient[2] = {-factor * a[1], factor * a[0]};
  gradient[0] = -1.0 * (gradient[1] + gradient[2]);
}

/// Of a tetrahedron likewise, of faces.
template <>
Simplex<3>::Simplex(const Places& x) {
  measure = dot(x[3] - x[0], cross(x[1] - x[0], x[2] - x[0])) / 6;
  const double factor = 1 / (6 * measure);
  const auto a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  gradient[1] = factor * cross(b, c);
  gradient[2] = factor * cross(c, a);
  gradient[3] = factor * cross(a, b);
  gradient[0] = -1.0 * (gradient[1] + gradient[2] + gradient[3]);
}

std::array<double, 6> stress_of(const Lame& m, const Simplex<3>::Slope& slope) {
  const double swelling = m.lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
  const auto stress = [&](int c, int d) { return m.mu * (slope[c][d] + slope[d][c]) + (c == d ? swelling : 0); };
  return {stress(0, 0), stress(0, 1), stress(0, 2), stress(1, 1), stress(1, 2), stress(2, 2)};
}

std::array<double, 3> stress_of(const Lame& m, const Simplex<2>::Slope& slope) {
  const double swelling = m.lambda * (slope[0][0] + slope[1][1]);
  return {swelling + 2 * m.mu * slope[0][0], swelling + 2 * m.mu * slope[1][1], m.mu * (slope[0][1] + slope[1][0])};
}

template <int dim>
EdgeStiffness edge_stiffness(const Simplex<dim>& cell, const Lame& m) {
  constexpr int edges = dim * Simplex<dim>::edges, corners = dim * Simplex<dim>::corners;
  constexpr double mean = 4.0 / (dim + 1), product = 16.0 / ((dim + 1) * (dim + 2));
  const auto& g = cell.gradient;
  EdgeStiffness k{std::vector<double>(edges * corners), std::vector<double>(edges * edges)};
  for (int row = 0; row < edges; ++row) {
    const auto& e = simplex_edges[row / dim];
    for (int column = 0; column < corners; ++column)
      k.with_corners[row * corners + column] =
          mean * cell.measure * coupled<dim>(m, g[e[0]] + g[e[1]], g[column / dim], row % dim, column % dim);
    for (int column = 0; column < edges; ++column) {
      const auto& f = simplex_edges[column / dim];
      double sum = 0;
      for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q)
          sum += (e[p] == f[q] ? 2 : 1) * coupled<dim>(m, g[e[1 - p]], g[f[1 - q]], row % dim, column % dim);
      k.with_edges[row * edges + column] = product * cell.measure * sum;
    }
  }
  return k;
}

template <int dim>
typename Simplex<dim>::Slope edge_slope(const Simplex<dim>& cell, const typename Simplex<dim>::OfEdges& amount) {
  typename Simplex<dim>::Slope slope{};
  for (int e = 0; e < Simplex<dim>::edges; ++e) {
    const auto mean = 4.0 / (dim + 1) * (cell.gradient[simplex_edges[e][0]] + cell.gradient[simplex_edges[e][1]]);
    for (int c = 0; c < dim; ++c) slope[c] = slope[c] + amount[e][c] * mean;
  }
  return slope;
}

template EdgeStiffness edge_stiffness(const Simplex<2>&, const Lame&);
template EdgeStiffness edge_stiffness(const Simplex<3>&, const Lame&);
template Simplex<2>::Slope edge_slope(const Simplex<2>&, const Simplex<2>::OfEdges&);
template Simplex<3>::Slope edge_slope(const Simplex<3>&, const Simplex<3>::OfEdges&);

}  // namespace voussoir
