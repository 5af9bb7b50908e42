#include "linalg/sparse_lu.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

namespace {

using namespace voussoir;

/// Tridiagonal, with a coupling one way from the last unknown to the first.
LocalCsr one_way(int n, double coupling) {
  LocalCsr a;
  for (int i = 0; i < n; ++i) {
    for (int j : {i - 1, i, i + 1})
      if (j >= 0 && j < n) {
        a.column.push_back(j);
        a.value.push_back(j == i ? 3.0 + i : j < i ? -1.0 : -0.5);
      }
    if (i == 0) {
      a.column.push_back(n - 1);
      a.value.push_back(coupling);
    }
    a.start.push_back(static_cast<int>(a.column.size()));
  }
  return a;
}

TEUCHOS_UNIT_TEST(SparseLu, SolvesUnsymmetricSystemsOfOnePattern) {
  const int n = 20;
  SparseLu lu;
  for (const double coupling : {7.0, -40.0}) {
    const auto a = one_way(n, coupling);
    lu.factor(a);
    std::vector<double> expected(n), b(n), x(n);
    for (int i = 0; i < n; ++i) expected[i] = std::cos(i);
    a.multiply(expected.data(), b.data());
    TEST_ASSERT(lu.solve(a, b.data(), x.data()));
    TEST_COMPARE_FLOATING_ARRAYS(x, expected, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(SparseLu, SaysThatAMatrixIsSingular) {
  LocalCsr a;
  a.start = {0, 2, 4};
  a.column = {0, 1, 0, 1};
  a.value = {1, 2, 2, 4};
  SparseLu lu;
  lu.factor(a);
  const double b[] = {1, 1};
  double x[2];
  TEST_ASSERT(!lu.solve(a, b, x));
}

}  // namespace
