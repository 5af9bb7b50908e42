#include "linalg/sparse_lu.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "linalg/solver_failure.hpp"

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
    TEST_ASSERT(lu.factor(a));
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
  TEST_ASSERT(firm.factor(grid(n, 4.0)));
  TEST_ASSERT(weak.factor(grid(n, 1e-5)));
  TEST_ASSERT(none.factor(grid(n, 1e-12)));
  out << firm.bytes() << ", " << weak.bytes() << ", " << none.bytes() << " bytes\n";
  TEST_EQUALITY(weak.bytes(), firm.bytes());
  TEST_COMPARE(none.bytes(), >, firm.bytes());
  TEST_COMPARE(error(weak, grid(n, 1e-5)), <, 1e-8);
  TEST_COMPARE(error(none, grid(n, 1e-12)), <, 1e-8);
}

LocalCsr two_by_two(std::vector<double> values) {
  LocalCsr a;
  a.start = {0, 2, 4};
  a.column = {0, 1, 0, 1};
  a.value = std::move(values);
  return a;
}

TEUCHOS_UNIT_TEST(SparseLu, SaysThatAMatrixIsSingularOrNoMatrixOfNumbersAndServesTheNextOne) {
  const double b[] = {1, 1}, nan = std::numeric_limits<double>::quiet_NaN();
  double x[2];
  SparseLu lu;
  for (const auto& a : {two_by_two({1, 2, 2, 4}), two_by_two({0, 0, 0, 0}), two_by_two({nan, 1, 1, 1})}) {
    TEST_ASSERT(!lu.factor(a));
    TEST_ASSERT(!lu.solve(a, b, x));
  }
  const auto good = two_by_two({2, 1, 1, 3});
  TEST_ASSERT(lu.factor(good));
  TEST_ASSERT(lu.solve(good, b, x));
  TEST_FLOATING_EQUALITY(x[0], 0.4, 1e-14);
}

/// What the library is heard to say of work that it refuses.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const SolverFailure& failure) {
    return failure.what();
  }
  return "nothing";
}

TEUCHOS_UNIT_TEST(SparseLu, WhatItsLibraryRefusesIsAFailureThatNamesItAndItsStatus) {
  auto twice = two_by_two({1, 2, 2, 5});
  twice.column = {0, 0, 0, 1};  // UMFPACK_ERROR_invalid_matrix
  SparseLu lu;
  TEST_EQUALITY(refusal([&] { return lu.factor(twice); }), "UMFPACK could not order a matrix (its status: -8)");
  auto other = two_by_two({1, 2, 2, 5});
  TEST_ASSERT(lu.factor(other));
  other.start = {0, 1, 2};  // another pattern than the one that was ordered
  other.column = {0, 1};
  TEST_EQUALITY(refusal([&] { return lu.factor(other); }), "UMFPACK could not factor a matrix (its status: -11)");
}

}  // namespace
