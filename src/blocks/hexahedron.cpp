#include "blocks/hexahedron.hpp"

#include <algorithm>
#include <utility>

namespace voussoir {
namespace {

constexpr std::array<Vector<3>, 8> corners_of_cube{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

const double gauss = 1 / std::sqrt(3.0);  // of two points in each direction, of weight 1

struct Point {
  double weight = 0;                    ///< [m3] Jacobian; Gauss weights are 1
  std::array<Vector<3>, 3> slope{};     ///< [1/m] gradients of the reference coordinates
  std::array<double, 8> value{};        ///< [-] of the shape functions
  std::array<Vector<3>, 8> gradient{};  ///< [1/m]
};

Point point_at(const std::array<Vector<3>, 8>& x, const Vector<3>& xi) {
  std::array<Vector<3>, 8> reference;
  std::array<Vector<3>, 3> along{};  // derivatives of the place by the reference coordinates
  Point p;
  for (int i = 0; i < 8; ++i) {
    const auto& c = corners_of_cube[i];
    const Vector<3> factor{1 + c[0] * xi[0], 1 + c[1] * xi[1], 1 + c[2] * xi[2]};
    p.value[i] = factor[0] * factor[1] * factor[2] / 8;
    reference[i] = {c[0] * factor[1] * factor[2] / 8, c[1] * factor[2] * factor[0] / 8,
                    c[2] * factor[0] * factor[1] / 8};
    for (int k = 0; k < 3; ++k) along[k] = along[k] + reference[i][k] * x[i];
  }
  p.weight = dot(along[0], cross(along[1], along[2]));
  for (int k = 0; k < 3; ++k) {
    p.slope[k] = (1 / p.weight) * cross(along[(k + 1) % 3], along[(k + 2) % 3]);
    for (int i = 0; i < 8; ++i) p.gradient[i] = p.gradient[i] + reference[i][k] * p.slope[k];
  }
  return p;
}

/// Gradients of the three modes 1 - xi_k^2, by the Jacobian of the middle: their integrals over the cell vanish, so
/// that uniform stress does no work on them however the cell is distorted.
std::array<Vector<3>, 3> gradients_of_modes(const Point& middle, const Point& here, const Vector<3>& xi) {
  std::array<Vector<3>, 3> gradient;
  for (int k = 0; k < 3; ++k) gradient[k] = (-2 * xi[k] * middle.weight / here.weight) * middle.slope[k];
  return gradient;
}

/// Takes the last unknown out of a matrix of n rows, as nothing acts on it.
void condense_last(std::vector<double>& k, int n) {
  const int last = n - 1;
  const double pivot = k[last * n + last];
  std::vector<double> rest(static_cast<std::size_t>(last) * last);
  for (int row = 0; row < last; ++row)
    for (int column = 0; column < last; ++column)
      rest[row * last + column] = k[row * n + column] - k[row * n + last] * k[last * n + column] / pivot;
  k = std::move(rest);
}

}  // namespace

std::vector<double> hexahedron_stiffness(const std::array<Vector<3>, 8>& x, const Material& m, Hexahedra kind) {
  const int shapes = kind == Hexahedra::incompatible ? 11 : 8, n = 3 * shapes;
  const double e = m.young_modulus, nu = m.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));  // Lame
  const auto middle = point_at(x, {0, 0, 0});
  std::vector<double> k(static_cast<std::size_t>(n) * n, 0.0);
  for (const auto& corner : corners_of_cube) {
    const auto xi = gauss * corner;
    const auto p = point_at(x, xi);
    std::array<Vector<3>, 11> gradient{};
    std::copy(p.gradient.begin(), p.gradient.end(), gradient.begin());
    const auto modes = gradients_of_modes(middle, p, xi);
    std::copy(modes.begin(), modes.end(), gradient.begin() + 8);
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const auto &a = gradient[row / 3], &b = gradient[column / 3];
        const int i = row % 3, j = column % 3;
        const double stress = lambda * a[i] * b[j] + mu * (a[j] * b[i] + (i == j ? dot(a, b) : 0));
        k[row * n + column] += p.weight * stress;
      }
  }
  for (int size = n; size > 24; --size) condense_last(k, size);
  return k;
}

std::array<double, 8> hexahedron_volumes(const std::array<Vector<3>, 8>& x) {
  std::array<double, 8> share{};
  for (const auto& corner : corners_of_cube) {
    const auto p = point_at(x, gauss * corner);
    for (int i = 0; i < 8; ++i) share[i] += p.weight * p.value[i];
  }
  return share;
}

std::vector<double> hexahedron_products(const std::array<Vector<3>, 8>& x) {
  std::vector<double> product(64, 0.0);
  for (const auto& corner : corners_of_cube) {
    const auto p = point_at(x, gauss * corner);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) product[8 * i + j] += p.weight * p.value[i] * p.value[j];
  }
  return product;
}

std::array<double, 6> hexahedron_stress(const std::array<Vector<3>, 8>& x, const std::array<Vector<3>, 8>& u,
                                        const Material& m) {
  const double e = m.young_modulus, nu = m.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  std::array<Vector<3>, 3> slope{};  // integral of the derivatives [c][d] of component c by place d
  double volume = 0;
  for (const auto& corner : corners_of_cube) {
    const auto p = point_at(x, gauss * corner);
    volume += p.weight;
    for (int i = 0; i < 8; ++i)
      for (int c = 0; c < 3; ++c) slope[c] = slope[c] + (p.weight * u[i][c]) * p.gradient[i];
  }
  const double swelling = lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
  const auto stress = [&](int c, int d) {
    return (mu * (slope[c][d] + slope[d][c]) + (c == d ? swelling : 0)) / volume;
  };
  return {stress(0, 0), stress(0, 1), stress(0, 2), stress(1, 1), stress(1, 2), stress(2, 2)};
}

}  // namespace voussoir
