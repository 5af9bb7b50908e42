// Small dense systems, by hand.
#include "base/dense.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <stdexcept>

namespace {

using namespace voussoir;

TEUCHOS_UNIT_TEST(Dense, APositiveMatrixOfThreeIsDivided) {
  // 4 1 0 / 1 3 1 / 0 1 2 times (1, 2, 3) is (6, 10, 8); the solution carries a few last bits.
  const auto x = solve_positive(Matrix<3>{{{4, 1, 0}, {1, 3, 1}, {0, 1, 2}}}, Vector<3>{6, 10, 8});
  for (int c = 0; c < 3; ++c) TEST_FLOATING_EQUALITY(x[c], c + 1.0, 1e-14);
  // Numbers as large as a stiffness, one direction a million times softer.
  const auto soft = solve_positive(Matrix<3>{{{2e12, 0, 0}, {0, 2e12, 0}, {0, 0, 2e6}}}, Vector<3>{2, 4, 6});
  TEST_FLOATING_EQUALITY(soft[2], 3e-6, 1e-14);
}

TEUCHOS_UNIT_TEST(Dense, WhereNothingResistsThereIsNoMotion) {
  const auto x = solve_positive(Matrix<3>{{{2, 0, 0}, {0, 0, 0}, {0, 0, 4}}}, Vector<3>{2, 7, 8});
  TEST_EQUALITY_CONST(x[0], 1.0);
  TEST_EQUALITY_CONST(x[1], 0.0);
  TEST_EQUALITY_CONST(x[2], 2.0);
}

TEUCHOS_UNIT_TEST(Dense, AChainOfSpringsHeldAtItsEndIsDivided) {
  // Springs of one between six nodes, the first held: under a force of one at the last, node i moves by i.
  const int n = 6;
  std::vector<double> a(n * n, 0.0), b(n, 0.0);
  a[0] = 1;
  for (int i = 1; i < n; ++i) {
    a[i * n + i] = i + 1 < n ? 2 : 1;
    if (i > 1) a[i * n + i - 1] = a[(i - 1) * n + i] = -1;
  }
  b[n - 1] = 1;
  solve_positive(a, b);
  for (int i = 1; i < n; ++i) TEST_FLOATING_EQUALITY(b[i], double(i), 1e-14);
  TEST_EQUALITY_CONST(b[0], 0.0);
  std::vector<double> floating{1, -1, -1, 1}, force{1, -1};
  TEST_THROW(solve_positive(floating, force), std::logic_error);
}

TEUCHOS_UNIT_TEST(Dense, AGeneralMatrixIsDividedThoughItsFirstPivotIsZero) {
  const Matrix<3> m{{{0, 2, 0}, {1, 0, 1}, {0, 0, 4}}}, x{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  Matrix<3> a{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) a[i][j] += m[i][k] * x[k][j];
  const auto found = solve_general(m, a);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) TEST_FLOATING_EQUALITY(found[i][j], x[i][j], 1e-14);
}

TEUCHOS_UNIT_TEST(Dense, DeterminantOfThree) {
  TEST_EQUALITY_CONST(determinant({{{0, 2, 0}, {1, 0, 1}, {0, 0, 4}}}), -8.0);
}

}  // namespace
