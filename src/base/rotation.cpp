#include "base/rotation.hpp"

#include "base/dense.hpp"

namespace voussoir {

template <>
Rotation<2> NearestRotation<2>::found() const {
  return Rotation<2>(
      std::atan2(motions_[0][1] - motions_[1][0], arms_[0][0] + arms_[1][1] + motions_[0][0] + motions_[1][1]));
}

/// The quaternion is the direction in which Horn's matrix is largest.
template <>
Rotation<3> NearestRotation<3>::found() const {
  const auto along = [&](int a, int b) { return arms_[a][b] + motions_[a][b]; };
  Matrix<4> horn;
  horn[0][0] = along(0, 0) + along(1, 1) + along(2, 2);
  bool turns = false;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    horn[0][a + 1] = horn[a + 1][0] = motions_[b][c] - motions_[c][b];
    turns |= horn[0][a + 1] != 0;
    horn[a + 1][a + 1] = along(a, a) - along(b, b) - along(c, c);
    horn[b + 1][c + 1] = horn[c + 1][b + 1] = along(b, c) + along(c, b);
  }
  const auto [value, vector] = eigenvectors(horn);
  // Whoever does not turn stays as drawn, to the last bit: then the first entry is an eigenvalue, and the largest.
  if (!turns && horn[0][0] > value[2]) return {};
  const auto& q = vector[3];
  return Rotation<3>::of_quaternion(q[0], {q[1], q[2], q[3]});
}

}  // namespace voussoir
