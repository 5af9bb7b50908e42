#include "joints/contact_law.hpp"

#include <utility>

namespace voussoir {

PointStiffness in_series(const PointStiffness& law, const PointCompliance& mortar, int components) {
  if (mortar.normal == 0 && mortar.tangential == 0) return law;
  std::array<std::array<double, 3>, 3> a{}, m{};  // the law; 1 + A C, which becomes 1 while A becomes what is sought
  for (int i = 0; i < components; ++i)
    for (int j = 0; j < components; ++j) {
      a[i][j] = i == 0   ? (j == 0 ? law.normal : law.pull[j - 1])
                : j == 0 ? law.coupling[i - 1]
                         : law.along(i - 1, j - 1);
      m[i][j] = (i == j) + a[i][j] * mortar.along(j);
    }
  for (int p = 0; p < components; ++p) {
    int row = p;
    for (int i = p + 1; i < components; ++i)
      if (std::abs(m[i][p]) > std::abs(m[row][p])) row = i;
    std::swap(m[p], m[row]);
    std::swap(a[p], a[row]);
    const double pivot = m[p][p];
    for (int j = 0; j < components; ++j) {
      m[p][j] /= pivot;
      a[p][j] /= pivot;
    }
    for (int i = 0; i < components; ++i) {
      if (i == p) continue;
      const double factor = m[i][p];
      for (int j = 0; j < components; ++j) {
        m[i][j] -= factor * m[p][j];
        a[i][j] -= factor * a[p][j];
      }
    }
  }
  PointStiffness s;
  s.normal = a[0][0];
  for (int t = 0; t + 1 < components; ++t) {
    s.coupling[t] = a[t + 1][0];
    s.pull[t] = a[0][t + 1];
  }
  // Along and across the direction of slip mortar gives way alike, so what is symmetric stays so.
  s.tangential = {a[1][1], components == 3 ? (a[1][2] + a[2][1]) / 2 : 0.0, components == 3 ? a[2][2] : 0.0};
  return s;
}

}  // namespace voussoir
