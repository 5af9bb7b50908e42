// Small vectors of fixed length, enough for geometry and pointwise laws.
// Templated on the scalar so that tests can push automatic differentiation through.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace voussoir {

template <int dim, class T = double>
using Vector = std::array<T, static_cast<std::size_t>(dim)>;

template <std::size_t n, class T>
std::array<T, n> operator+(std::array<T, n> a, const std::array<T, n>& b) {
  for (std::size_t i = 0; i < n; ++i) a[i] += b[i];
  return a;
}

template <std::size_t n, class T>
std::array<T, n> operator-(std::array<T, n> a, const std::array<T, n>& b) {
  for (std::size_t i = 0; i < n; ++i) a[i] -= b[i];
  return a;
}

template <std::size_t n, class T>
std::array<T, n> operator*(const T& s, std::array<T, n> a) {
  for (std::size_t i = 0; i < n; ++i) a[i] *= s;
  return a;
}

template <std::size_t n, class T>
T dot(const std::array<T, n>& a, const std::array<T, n>& b) {
  T sum = a[0] * b[0];
  for (std::size_t i = 1; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t n, class T>
T norm(const std::array<T, n>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Cross product of the plane, a scalar: positive when b lies counter-clockwise of a.
template <class T>
T cross(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Cross product of space.
template <class T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace voussoir
