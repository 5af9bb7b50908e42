// What stones laid round an axis or a centre share: directions at angles, and plane faces between lines of a lattice.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/tensor.hpp"

namespace voussoir {

/// Cosine and sine of an angle [degree]: exact at quarters of a turn, and the same bits at mirrored angles.
inline Vector<2> direction_at(double degrees) {
  const double quarters = std::round(degrees / 90);
  const double rest = (degrees - 90 * quarters) * (std::acos(-1.0) / 180);
  const double c = std::cos(rest), s = std::sin(rest);
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

/// Two lines of a lattice between which faces are plane, and how far from the first to the second a line lies.
struct Stretch {
  int from, to;
  double share;  ///< 0 at `from`
};

/// @param stride  lines from one to the next of those that lie on the round surface; 1 when all do
inline Stretch stretch_of(int line, int stride) {
  const int from = static_cast<int>(std::floor(line / double(stride))) * stride;
  return {from, from + stride, (line - from) / double(stride)};
}

/// The place of a line, where at(n) is that of line n on the round surface.
template <class At>
Vector<3> stretched(const Stretch& s, const At& at) {
  if (s.share == 0) return at(s.from);
  return (1 - s.share) * at(s.from) + s.share * at(s.to);
}

}  // namespace voussoir
