// Where a drawing puts what it has drawn once: affine maps of the plane.
#pragma once

#include <cmath>

#include "base/tensor.hpp"

namespace voussoir {

/// x goes to (a x + c y + e, b x + d y + f).
struct Transform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vector<2> operator()(const Vector<2>& x) const { return {a * x[0] + c * x[1] + e, b * x[0] + d * x[1] + f}; }
  /// The one that does `first`, then this.
  Transform after(const Transform& first) const {
    const Vector<2> shift = (*this)({first.e, first.f});
    return {a * first.a + c * first.b,
            b * first.a + d * first.b,
            a * first.c + c * first.d,
            b * first.c + d * first.d,
            shift[0],
            shift[1]};
  }
  static Transform moved(double x, double y) { return {1, 0, 0, 1, x, y}; }
  static Transform scaled(double x, double y) { return {x, 0, 0, y, 0, 0}; }
  /// Quarters of a turn are exact, as drawings mean them.
  static Transform turned(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::round(quarters)) {
      const auto k = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4));
      const double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
      return {cosine[k], sine[k], -sine[k], cosine[k], 0, 0};
    }
    const double angle = degrees * std::acos(-1.0) / 180;
    return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
  }
};

}  // namespace voussoir
