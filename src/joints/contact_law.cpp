#include "joints/contact_law.hpp"

#include "base/dense.hpp"

namespace voussoir {

PointStiffness in_series(const PointStiffness& law, const PointCompliance& mortar, int components) {
  if (mortar.normal == 0 && mortar.tangential == 0) return law;
  Matrix<3> law_of{}, series{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // A, and 1 + A C
  for (int i = 0; i < components; ++i)
    for (int j = 0; j < components; ++j) {
      law_of[i][j] = i == 0   ? (j == 0 ? law.normal : law.pull[j - 1])
                     : j == 0 ? law.coupling[i - 1]
                              : law.along(i - 1, j - 1);
      series[i][j] += law_of[i][j] * mortar.along(j);
    }
  const auto a = solve_general(series, law_of);
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
