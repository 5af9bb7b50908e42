#include "base/rotation.hpp"

#include "base/dense.hpp"

namespace voussoir {

/// The quaternion is the direction in which Horn's matrix is largest.
Rotation<3> nearest_rotation(const std::array<Vector<3>, 3>& arms, const std::array<Vector<3>, 3>& motions) {
  const auto along = [&](int a, int b) { return arms[a][b] + motions[a][b]; };
  Matrix<4> horn;
  horn[0][0] = along(0, 0) + along(1, 1) + along(2, 2);
  bool turns = false;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    horn[0][a + 1] = horn[a + 1][0] = motions[b][c] - motions[c][b];
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
