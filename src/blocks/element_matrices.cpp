#include "blocks/element_matrices.hpp"

namespace voussoir {
namespace {

constexpr std::array<Vector<2>, 4> corners_of_square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

ShapeValues triangle_values(const std::array<Vector<2>, 4>& x) {
  ShapeValues s;
  const double double_area = cross(x[1] - x[0], x[2] - x[0]);
  for (int i = 0; i < 3; ++i) {
    const auto& a = x[(i + 1) % 3];
    const auto& b = x[(i + 2) % 3];
    s.value[i] = 1.0 / 3;
    s.gradient[i] = {(a[1] - b[1]) / double_area, (b[0] - a[0]) / double_area};
  }
  s.weight = double_area / 2;
  return s;
}

ShapeValues quadrilateral_values(const std::array<Vector<2>, 4>& x, const Vector<2>& xi) {
  ShapeValues s;
  std::array<Vector<2>, 4> reference;
  Vector<2> dx{}, dy{};  // derivatives of x and y by the reference coordinates
  for (int i = 0; i < 4; ++i) {
    const auto& c = corners_of_square[i];
    s.value[i] = (1 + c[0] * xi[0]) * (1 + c[1] * xi[1]) / 4;
    reference[i] = {c[0] * (1 + c[1] * xi[1]) / 4, c[1] * (1 + c[0] * xi[0]) / 4};
    dx = dx + x[i][0] * reference[i];
    dy = dy + x[i][1] * reference[i];
  }
  const double det = cross(dx, dy);
  for (int i = 0; i < 4; ++i) s.gradient[i] = {cross(reference[i], dy) / det, cross(dx, reference[i]) / det};
  s.weight = det;
  return s;
}

}  // namespace

std::vector<ShapeValues> shape_values(const Cell& cell, const std::array<Vector<2>, 4>& x) {
  if (cell.count == 3) return {triangle_values(x)};
  const double g = 1 / std::sqrt(3.0);  // 2 x 2 Gauss points integrate the stiffness of a parallelogram exactly
  std::vector<ShapeValues> points;
  for (const auto& c : corners_of_square) points.push_back(quadrilateral_values(x, g * c));
  return points;
}

std::vector<double> element_stiffness(const Cell& cell, const std::array<Vector<2>, 4>& x, const Material& material,
                                      Plane plane, double thickness) {
  const int n = 2 * cell.count;
  const auto d = plane_elasticity(material, plane);
  std::vector<double> k(n * n, 0.0);
  for (const auto& s : shape_values(cell, x))
    for (int i = 0; i < cell.count; ++i)
      for (int j = 0; j < cell.count; ++j) {
        const auto& a = s.gradient[i];
        const auto& b = s.gradient[j];
        const double w = s.weight * thickness;
        k[2 * i * n + 2 * j] += w * (a[0] * d[0][0] * b[0] + a[1] * d[2][2] * b[1]);
        k[2 * i * n + 2 * j + 1] += w * (a[0] * d[0][1] * b[1] + a[1] * d[2][2] * b[0]);
        k[(2 * i + 1) * n + 2 * j] += w * (a[1] * d[1][0] * b[0] + a[0] * d[2][2] * b[1]);
        k[(2 * i + 1) * n + 2 * j + 1] += w * (a[1] * d[1][1] * b[1] + a[0] * d[2][2] * b[0]);
      }
  return k;
}

std::vector<double> element_products(const Cell& cell, const std::array<Vector<2>, 4>& x, double thickness) {
  const int n = cell.count;
  std::vector<double> m(n * n, 0.0);
  if (n == 3) {  // one point is too few for products of linear functions: area / 12 x (1 + delta_ij)
    const double area = shape_values(cell, x).front().weight;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m[i * n + j] = area * thickness / 12 * (i == j ? 2 : 1);
    return m;
  }
  for (const auto& s : shape_values(cell, x))
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m[i * n + j] += s.weight * thickness * s.value[i] * s.value[j];
  return m;
}

std::array<double, 4> element_volumes(const Cell& cell, const std::array<Vector<2>, 4>& x, double thickness) {
  std::array<double, 4> volume{};
  for (const auto& s : shape_values(cell, x))
    for (int i = 0; i < cell.count; ++i) volume[i] += s.weight * thickness * s.value[i];
  return volume;
}

std::array<double, 3> element_stress(const Cell& cell, const std::array<Vector<2>, 4>& x,
                                     const std::array<Vector<2>, 4>& u, const Material& material, Plane plane) {
  const auto d = plane_elasticity(material, plane);
  std::array<double, 3> strain{};
  double volume = 0;
  for (const auto& s : shape_values(cell, x)) {
    for (int i = 0; i < cell.count; ++i) {
      const auto& g = s.gradient[i];
      strain[0] += s.weight * g[0] * u[i][0];
      strain[1] += s.weight * g[1] * u[i][1];
      strain[2] += s.weight * (g[1] * u[i][0] + g[0] * u[i][1]);
    }
    volume += s.weight;
  }
  std::array<double, 3> stress{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) stress[i] += d[i][j] * strain[j] / volume;
  return stress;
}

}  // namespace voussoir
