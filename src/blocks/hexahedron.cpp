#include "blocks/hexahedron.hpp"

namespace voussoir {
namespace {

constexpr std::array<Vector<3>, 8> corners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

struct Point {
  double weight = 0;                    ///< [m3] Jacobian; Gauss weights are 1
  std::array<Vector<3>, 8> gradient{};  ///< [1/m] of the shape functions
};

Point point_at(const std::array<Vector<3>, 8>& x, const Vector<3>& xi) {
  std::array<Vector<3>, 8> reference;
  std::array<Vector<3>, 3> along{};  // derivatives of the place by the reference coordinates
  for (int i = 0; i < 8; ++i) {
    const auto& c = corners[i];
    const Vector<3> factor{1 + c[0] * xi[0], 1 + c[1] * xi[1], 1 + c[2] * xi[2]};
    reference[i] = {c[0] * factor[1] * factor[2] / 8, c[1] * factor[2] * factor[0] / 8,
                    c[2] * factor[0] * factor[1] / 8};
    for (int k = 0; k < 3; ++k) along[k] = along[k] + reference[i][k] * x[i];
  }
  Point p;
  p.weight = dot(along[0], cross(along[1], along[2]));
  for (int k = 0; k < 3; ++k) {
    const auto slope = (1 / p.weight) * cross(along[(k + 1) % 3], along[(k + 2) % 3]);
    for (int i = 0; i < 8; ++i) p.gradient[i] = p.gradient[i] + reference[i][k] * slope;
  }
  return p;
}

}  // namespace

std::vector<double> hexahedron_stiffness(const std::array<Vector<3>, 8>& x, const Material& m) {
  constexpr int n = 24;
  const double e = m.young_modulus, nu = m.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));  // Lame
  const double g = 1 / std::sqrt(3.0);
  std::vector<double> k(n * n, 0.0);
  for (const auto& corner : corners) {
    const auto p = point_at(x, g * corner);
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const auto &a = p.gradient[row / 3], &b = p.gradient[column / 3];
        const int i = row % 3, j = column % 3;
        const double stress = lambda * a[i] * b[j] + mu * (a[j] * b[i] + (i == j ? dot(a, b) : 0));
        k[row * n + column] += p.weight * stress;
      }
  }
  return k;
}

std::array<double, 8> hexahedron_volumes(const std::array<Vector<3>, 8>& x) {
  const double g = 1 / std::sqrt(3.0);
  std::array<double, 8> share{};
  for (const auto& corner : corners) {
    const auto xi = g * corner;
    const auto p = point_at(x, xi);
    for (int i = 0; i < 8; ++i)
      share[i] +=
          p.weight * (1 + corners[i][0] * xi[0]) * (1 + corners[i][1] * xi[1]) * (1 + corners[i][2] * xi[2]) / 8;
  }
  return share;
}

}  // namespace voussoir
