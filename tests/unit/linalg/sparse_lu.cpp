#include "linalg/sparse_lu.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <vector>

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

/// Five-point grid of n x n whose every third unknown has a diagonal of its own.
LocalCsr grid(int n, double third) {
  LocalCsr a;
  for (int i = 0; i < n * n; ++i) {
    for (int j : {i - n, i - 1, i, i + 1, i + n}) {
      if (j < 0 || j >= n * n || (std::abs(j - i) == 1 && i / n != j / n)) continue;
      a.column.push_back(j);
      a.value.push_back(j != i ? -1.0 - 0.1 * std::sin(j) : i % 3 == 0 ? third : 4.0);
    }
    a.start.push_back(static_cast<int>(a.column.size()));
  }
  return a;
}

/// Largest error of a solution with unknowns of size 1.
double error(const SparseLu& lu, const LocalCsr& a) {
  std::vector<double> expected, b(a.rows()), x(a.rows());
  for (int i = 0; i < a.rows(); ++i) expected.push_back(std::cos(i));
  a.multiply(expected.data(), b.data());
  if (!lu.solve(a, b.data(), x.data())) return 1;
  double largest = 0;
  for (int i = 0; i < a.rows(); ++i) largest = std::max(largest, std::abs(x[i] - expected[i]));
  return largest;
}

// Stones that hardly anything holds are as cheap as others, and what has no pivot on the diagonal at all is solved.
TEUCHOS_UNIT_TEST(SparseLu, TakesWeakPivotsOnTheDiagonalButNotNone) {
  const int n = 60;
  SparseLu firm, weak, none;
  firm.factor(grid(n, 4.0));
  weak.factor(grid(n, 1e-5));
  none.factor(grid(n, 1e-12));
  out << firm.bytes() << ", " << weak.bytes() << ", " << none.bytes() << " bytes\n";
  TEST_EQUALITY(weak.bytes(), firm.bytes());
  TEST_COMPARE(none.bytes(), >, firm.bytes());
  TEST_COMPARE(error(weak, grid(n, 1e-5)), <, 1e-8);
  TEST_COMPARE(error(none, grid(n, 1e-12)), <, 1e-8);
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
