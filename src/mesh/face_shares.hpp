// What each corner of a face in space stands for.
#pragma once

#include <cmath>

#include "base/tensor.hpp"

namespace voussoir {

/// Of the corners of a face: integral of the shape function times the normal [m2], by 2 x 2 Gauss points. The normal
/// points to where the corners are counter-clockwise.
inline std::array<Vector<3>, 4> shares_of_corners(const std::array<Vector<3>, 4>& x) {
  constexpr std::array<Vector<2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const double g = 1 / std::sqrt(3.0);
  std::array<Vector<3>, 4> share{};
  for (const auto& at : corners) {
    std::array<double, 4> value;
    Vector<3> along{}, up{};
    for (int i = 0; i < 4; ++i) {
      const double s = 1 + g * at[0] * corners[i][0], t = 1 + g * at[1] * corners[i][1];
      value[i] = s * t / 4;
      along = along + (corners[i][0] * t / 4) * x[i];
      up = up + (corners[i][1] * s / 4) * x[i];
    }
    for (int i = 0; i < 4; ++i) share[i] = share[i] + value[i] * cross(along, up);
  }
  return share;
}

}  // namespace voussoir
