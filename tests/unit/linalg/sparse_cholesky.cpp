// Direct solutions on one rank: regular, singular by rigid motions, and of another matrix with the same pattern.
#include "linalg/sparse_cholesky.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>

#include "linalg/solver_failure.hpp"
#include "unit/blocks/lattice_block.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

double largest(const std::vector<double>& v) {
  double value = 0;
  for (double x : v) value = std::max(value, std::abs(x));
  return value;
}

/// max |b - A x| / max |b|
double residual(const LocalCsr& a, const std::vector<double>& x, const std::vector<double>& b) {
  std::vector<double> r(b.size());
  a.multiply(x.data(), r.data());
  for (std::size_t i = 0; i < b.size(); ++i) r[i] -= b[i];
  return largest(r) / largest(b);
}

std::vector<double> noise_values(int size) {
  std::vector<double> v;
  for (int i = 0; i < size; ++i) v.push_back(noise(i));
  return v;
}

/// What SparseCholesky is given of a symmetric matrix.
LocalCsr upper(const LocalCsr& a) {
  LocalCsr u;
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = a.start[i]; k < a.start[i + 1]; ++k) {
      if (a.column[k] < i) continue;
      u.column.push_back(a.column[k]);
      u.value.push_back(a.value[k]);
    }
    u.start.push_back(static_cast<int>(u.column.size()));
  }
  return u;
}

// Condition below 100 and fewer than a thousand operations per row: 1e-12 is far above round-off.
constexpr double round_off = 1e-12;

TEUCHOS_UNIT_TEST(SparseCholesky, SolvesPositiveDefiniteSystems) {
  for (const int size : {1, 2, 31, 400}) {
    const auto a = local(size, scattered(size));
    const auto b = noise_values(size);
    std::vector<double> x(size);
    const SparseCholesky factor(upper(a));
    TEST_EQUALITY(factor.size(), size);
    factor.solve(b.data(), x.data());
    TEST_COMPARE(residual(a, x, b), <=, round_off);
  }
}

TEUCHOS_UNIT_TEST(SparseCholesky, TheSolutionMayOverwriteTheRightHandSide) {
  const auto a = local(50, scattered(50));
  const auto b = noise_values(50);
  auto x = b;
  SparseCholesky(upper(a)).solve(x.data(), x.data());
  TEST_COMPARE(residual(a, x, b), <=, round_off);
}

long threads() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), std::filesystem::directory_iterator());
}

TEUCHOS_UNIT_TEST(SparseCholesky, NoFactorisationStartsThreads) {
  LocalCsr dense;  // as one part of many columns, which CHOLMOD likes to share among threads
  constexpr int size = 300;
  for (int i = 0; i < size; ++i) {
    for (int j = i; j < size; ++j) {
      dense.column.push_back(j);
      dense.value.push_back(i == j ? 2.0 * size : 1.0);
    }
    dense.start.push_back(static_cast<int>(dense.column.size()));
  }
  const long before = threads();
  const SparseCholesky factor(dense);
  TEST_EQUALITY(threads(), before);
}

TEUCHOS_UNIT_TEST(SparseCholesky, ASystemOfNoUnknownsIsSolved) {
  const SparseCholesky factor{LocalCsr{}};
  TEST_EQUALITY(factor.size(), 0);
  TEST_NOTHROW(factor.solve(nullptr, nullptr));
}

TEUCHOS_UNIT_TEST(SparseCholesky, RefactorSolvesTheNewMatrixAlsoAfterAMove) {
  const auto b = noise_values(200);
  std::vector<double> x(200);
  SparseCholesky first(upper(local(200, scattered(200))));
  SparseCholesky factor(std::move(first));
  const auto other = local(200, scattered(200, 3.0));
  factor.refactor(upper(other));
  factor.solve(b.data(), x.data());
  TEST_COMPARE(residual(other, x, b), <=, round_off);
}

TEUCHOS_UNIT_TEST(SparseCholesky, AFloatingBlockIsRepairedAndFollowsForcesInEquilibrium) {
  // Rigid motions make the stiffness singular, so its last pivots are round-off of either sign. The repair adds
  // 1e-10 of the diagonal; forces in equilibrium then leave a residual of about 1e-10 times the condition (100).
  const auto block = block_of_cells(0, {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}});
  const auto k = block_stiffness(block, {1.0, 0.2, 1.0}, Plane::stress, 1.0);
  const auto u = noise_values(k.rows());
  std::vector<double> f(k.rows()), x(k.rows());
  k.multiply(u.data(), f.data());
  SparseCholesky factor(upper(k));
  factor.solve(f.data(), x.data());
  TEST_COMPARE(residual(k, x, f), <=, 1e-8);
  // A regular matrix of the same pattern is solved without repair afterwards.
  auto held = k;
  for (int i = 0; i < held.rows(); ++i)
    for (int entry = held.start[i]; entry < held.start[i + 1]; ++entry)
      if (held.column[entry] == i) held.value[entry] += 0.1;
  factor.refactor(upper(held));
  factor.solve(f.data(), x.data());
  TEST_COMPARE(residual(held, x, f), <=, round_off);
}

TEUCHOS_UNIT_TEST(SparseCholesky, AZeroPivotIsRepaired) {
  // x0 - x1 alone has stiffness: the second pivot is exactly zero.
  LocalCsr a;
  a.start = {0, 2, 3};
  a.column = {0, 1, 1};
  a.value = {1, -1, 1};
  const SparseCholesky factor(a);
  std::vector<double> x{1, -1};
  factor.solve(x.data(), x.data());
  TEST_FLOATING_EQUALITY(x[0] - x[1], 1.0, 1e-9);  // 1e-10 in two pivots, twice that by round-off of 1e-16 / 1e-10
}

TEUCHOS_UNIT_TEST(SparseCholesky, AnIndefiniteMatrixIsAFailureThatNamesTheLibraryAndTheNextOneIsSolved) {
  LocalCsr a;
  a.start = {0, 2, 3};
  a.column = {0, 1, 1};
  a.value = {1, 2, 1};
  TEST_THROW(SparseCholesky{a}, SolverFailure);
  a.value = {3, 1, 2};
  SparseCholesky factor(a);
  for (const double off : {2.0, -1e3}) {
    a.value = {1, off, 1};
    std::string said;
    try {
      factor.refactor(a);
    } catch (const SolverFailure& failure) {
      said = failure.what();
    }
    TEST_EQUALITY(said, "CHOLMOD could not factor a matrix that is not positive definite (its status: 1)");
  }
  a.value = {3, 1, 2};
  factor.refactor(a);
  std::vector<double> x{5, 5};
  factor.solve(x.data(), x.data());
  TEST_FLOATING_EQUALITY(x[0], 1.0, round_off);
  TEST_FLOATING_EQUALITY(x[1], 2.0, round_off);
}

// Small matrices are factored row by row, large ones by blocks of LAPACK.
TEUCHOS_UNIT_TEST(SparseCholesky, AnEntryThatIsNotFiniteIsAFailureWhereverItIs) {
  const auto nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const int size : {3, 31, 400}) {
    const auto good = upper(local(size, scattered(size)));
    SparseCholesky factor(good);
    const int entries = good.start.back();
    for (const int entry : {0, 1, entries / 2, entries - 2, entries - 1})
      for (const double wrong : {nan, infinite, -infinite}) {
        auto a = good;
        a.value[entry] = wrong;
        TEST_THROW(factor.refactor(a), SolverFailure);
      }
    factor.refactor(good);
    auto x = noise_values(size);
    factor.solve(x.data(), x.data());
    TEST_COMPARE(residual(local(size, scattered(size)), x, noise_values(size)), <=, round_off);
  }
}

// Each rank has blocks of its own: where one fails the others must not wait for it.
TEUCHOS_UNIT_TEST(SparseCholesky, WhatFailsOnOneRankFailsOnAllWithItsWords) {
  const auto comm = everyone();
  for (const int failing : {0, comm->getSize() - 1}) {
    std::string said;
    try {
      all_or_none(*comm, [&] {
        if (comm->getRank() == failing) throw SolverFailure("rank " + std::to_string(failing));
      });
    } catch (const SolverFailure& failure) {
      said = failure.what();
    }
    TEST_EQUALITY(said, "rank " + std::to_string(failing));
  }
  TEST_NOTHROW(all_or_none(*comm, [] {}));
}

}  // namespace
