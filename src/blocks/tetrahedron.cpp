#include "blocks/tetrahedron.hpp"

namespace voussoir {
std::vector<double> tetrahedron_stiffness(const std::array<Vector<3>, 4>& x, const Material& material) {
  constexpr int n = 12;
  const auto m = lame(material);
  const Simplex<3> cell(x);
  const auto& g = cell.gradient;
  std::vector<double> k(n * n, 0.0);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      k[row * n + column] = cell.measure * coupled<3>(m, g[row / 3], g[column / 3], row % 3, column % 3);
  return k;
}

std::array<double, 4> tetrahedron_volumes(const std::array<Vector<3>, 4>& x) {
  const double share = Simplex<3>(x).measure / 4;
  return {share, share, share, share};
}

std::vector<double> tetrahedron_products(const std::array<Vector<3>, 4>& x) {
  const double part = Simplex<3>(x).measure / 20;
  std::vector<double> product(16, part);
  for (int i = 0; i < 4; ++i) product[5 * i] = 2 * part;
  return product;
}

std::array<double, 6> tetrahedron_stress(const std::array<Vector<3>, 4>& x, const std::array<Vector<3>, 4>& u,
                                         const Material& material) {
  const auto g = Simplex<3>(x).gradient;
  Simplex<3>::Slope slope{};
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c) slope[c] = slope[c] + u[i][c] * g[i];
  return stress_of(lame(material), slope);
}

}  // namespace voussoir
