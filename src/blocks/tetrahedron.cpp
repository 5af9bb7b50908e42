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

}  // namespace

std::vector<double> tetrahedron_stiffness(const std::array<Vector<3>, 4>& x, const Material& material) {
  constexpr int n = 12;
  const Lame m(material);
  const auto g = gradients(x);
  const double volume = volume_of(x);
  std::vector<double> k(n * n, 0.0);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const auto &a = g[row / 3], &b = g[column / 3];
      const int i = row % 3, j = column % 3;
      k[row * n + column] = volume * (m.lambda * a[i] * b[j] + m.mu * (a[j] * b[i] + (i == j ? dot(a, b) : 0)));
    }
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
  std::array<Vector<3>, 3> slope{};  // derivatives [c][d] of component c by place d
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) slope[c] = slope[c] + u[i][c] * g[i];
  const double swelling = m.lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
  const auto stress = [&](int c, int d) { return m.mu * (slope[c][d] + slope[d][c]) + (c == d ? swelling : 0); };
  return {stress(0, 0), stress(0, 1), stress(0, 2), stress(1, 1), stress(1, 2), stress(2, 2)};
}

}  // namespace voussoir
