// What the stiffness of an element must be, whatever its shape.
#pragma once

#include <Teuchos_LAPACK.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <vector>

namespace voussoir::test {

/// Symmetric to round-off, with six rigid motions and no other that costs nothing: too few points of quadrature would
/// leave some.
/// @param k  n rows of n, of entries about 1
inline void check_six_rigid_motions(std::vector<double> k, int n, Teuchos::FancyOStream& out, bool& success) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) TEST_COMPARE(std::abs(k[i * n + j] - k[j * n + i]), <=, 1e-15 * 10);
  std::vector<double> eigenvalue(n), work(10 * n);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', n, k.data(), n, eigenvalue.data(), work.data(), 10 * n, &info);
  TEST_EQUALITY(info, 0);
  for (int i = 0; i < 6; ++i) TEST_COMPARE(std::abs(eigenvalue[i]), <=, 1e-14);
  TEST_COMPARE(eigenvalue[6], >=, 0.01 * eigenvalue[n - 1]);
}

}  // namespace voussoir::test
