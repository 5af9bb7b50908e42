#include "blocks/tetrahedron.hpp"

namespace voussoir {
namespace {

struct Lame {
  double lambda, mu;
  explicit Lame(const Material& m)
      : lambda(m.young_modulus * m.poisson_ratio / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio))),
        mu(m.young_modulus / (2 * (1 + m.poisson_ratio))) {}
};

double volume_of(const std::array<Vector<3>, 4>& x) { return dot(x[3] - x[0], cross(x[1] - x[0], x[2] - x[0])) / 6; }

/// [1/m] of the shape functions: the normal of the opposite face, inward, over the height.
std::array<Vector<3>, 4> gradients(const std::array<Vector<3>, 4>& x) {
  const double factor = 1 / (6 * volume_of(x));
  const auto a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  std::array<Vector<3>, 4> g{};
  g[1] = factor * cross(b, c);
  g[2] = factor * cross(c, a);
  g[3] = factor * cross(a, b);
  g[0] = -1.0 * (g[1] + g[2] + g[3]);
  return g;
}

/// Energy of two gradients, component i of displacement along a and j along b [Pa/m2].
double coupled(const Lame& m, const Vector<3>& a, const Vector<3>& b, int i, int j) {
  return m.lambda * a[i] * b[j] + m.mu * (a[j] * b[i] + (i == j ? dot(a, b) : 0));
}

/// Stress of the derivatives [c][d] of component c by place d.
std::array<double, 6> stress_of(const Lame& m, const std::array<Vector<3>, 3>& slope) {
  const double swelling = m.lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
  const auto stress = [&](int c, int d) { return m.mu * (slope[c][d] + slope[d][c]) + (c == d ? swelling : 0); };
  return {stress(0, 0), stress(0, 1), stress(0, 2), stress(1, 1), stress(1, 2), stress(2, 2)};
}

}  // namespace

std::vector<double> tetrahedron_stiffness(const std::array<Vector<3>, 4>& x, const Material& material) {
  constexpr int n = 12;
  const Lame m(material);
  const auto g = gradients(x);
  const double volume = volume_of(x);
  std::vector<double> k(n * n, 0.0);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      k[row * n + column] = volume * coupled(m, g[row / 3], g[column / 3], row % 3, column % 3);
  return k;
}

std::array<double, 4> tetrahedron_volumes(const std::array<Vector<3>, 4>& x) {
  const double share = volume_of(x) / 4;
  return {share, share, share, share};
}

std::vector<double> tetrahedron_products(const std::array<Vector<3>, 4>& x) {
  const double part = volume_of(x) / 20;
  std::vector<double> product(16, part);
  for (int i = 0; i < 4; ++i) product[5 * i] = 2 * part;
  return product;
}

std::array<double, 6> tetrahedron_stress(const std::array<Vector<3>, 4>& x, const std::array<Vector<3>, 4>& u,
                                         const Material& material) {
  const Lame m(material);
  const auto g = gradients(x);
  std::array<Vector<3>, 3> slope{};
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) slope[c] = slope[c] + u[i][c] * g[i];
  return stress_of(m, slope);
}

/// The gradient of 4 L_i L_j is 4 (L_i g_j + L_j g_i), its mean g_i + g_j; the integral of L_a L_b is V / 20, and twice
/// that where a = b.
EdgeStiffness tetrahedron_edge_stiffness(const std::array<Vector<3>, 4>& x, const Material& material) {
  constexpr int edges = 18, corners = 12;
  const Lame m(material);
  const auto g = gradients(x);
  const double volume = volume_of(x);
  EdgeStiffness k{std::vector<double>(edges * corners), std::vector<double>(edges * edges)};
  for (int row = 0; row < edges; ++row) {
    const auto& e = tetrahedron_edges[row / 3];
    for (int column = 0; column < corners; ++column)
      k.with_corners[row * corners + column] =
          volume * coupled(m, g[e[0]] + g[e[1]], g[column / 3], row % 3, column % 3);
    for (int column = 0; column < edges; ++column) {
      const auto& f = tetrahedron_edges[column / 3];
      double sum = 0;
      for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q)
          sum += (e[p] == f[q] ? 2 : 1) * coupled(m, g[e[1 - p]], g[f[1 - q]], row % 3, column % 3);
      k.with_edges[row * edges + column] = 16 * volume / 20 * sum;
    }
  }
  return k;
}

double tetrahedron_edge_volume(const std::array<Vector<3>, 4>& x) { return volume_of(x) / 5; }

std::array<double, 6> tetrahedron_edge_stress(const std::array<Vector<3>, 4>& x, const std::array<Vector<3>, 6>& amount,
                                              const Material& material) {
  const auto g = gradients(x);
  std::array<Vector<3>, 3> slope{};
  for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e)
    for (int c = 0; c < 3; ++c)
      slope[c] = slope[c] + amount[e][c] * (g[tetrahedron_edges[e][0]] + g[tetrahedron_edges[e][1]]);
  return stress_of(Lame(material), slope);
}

}  // namespace voussoir
