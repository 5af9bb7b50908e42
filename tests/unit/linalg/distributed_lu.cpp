#include "linalg/distributed_lu.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <memory>
#include <string>
#include <vector>

#include "linalg/solver_failure.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// As scattered, but what a row gives to another is not what it gets.
Rows unsymmetric(long long size, double scale) {
  return [size, scale](long long row) {
    auto entries = scattered(size)(row);
    for (auto& [column, value] : entries)
      if (column < row) value *= scale;
    return entries;
  };
}

TEUCHOS_UNIT_TEST(DistributedLu, SolvesUnsymmetricSystemsOfOnePattern) {
  for (const long long size : {1LL, 3LL, 500LL}) {  // fewer unknowns than ranks too
    std::unique_ptr<DistributedLu> lu;
    for (const double scale : {0.5, -1.0, 0.0}) {
      const auto a = distributed(size, unsymmetric(size, scale), everyone());
      if (!lu) lu = std::make_unique<DistributedLu>(a->getRowMap());
      TpetraVector x(a->getRowMap());
      const auto b = noise_vector(a->getRowMap());
      TEST_ASSERT(lu->factor(*a));
      lu->apply(*b, x);
      TEST_COMPARE(relative_residual(*a, *b, x), <=, 1e-12);  // dominated by their diagonals
    }
    if (size == 500) TEST_COMPARE(lu->bytes(), >, 0);
  }
}

// Clusters of nodes are numbered by their least node: numbers have gaps, and ranks own any of them.
TEUCHOS_UNIT_TEST(DistributedLu, TakesNumbersWithGaps) {
  const auto comm = everyone();
  const int n = 40;
  std::vector<GlobalOrdinal> mine;
  for (int i = 0; i < n; ++i)
    if (i % comm->getSize() == comm->getRank()) mine.push_back(7 * i + 3);
  const auto map = Teuchos::rcp(new TpetraMap(Tpetra::global_size_t(n), Teuchos::arrayViewFromVector(mine), 0, comm));
  TpetraMatrix a(map, 3);
  for (const auto row : mine) {
    std::vector<GlobalOrdinal> columns;
    std::vector<double> values;
    for (const auto column : {row - 7, row, row + 7}) {
      if (column < 3 || column >= 7 * n) continue;
      columns.push_back(column);
      values.push_back(column == row ? 3.0 : column < row ? -2.0 : 0.5);
    }
    a.insertGlobalValues(row, Teuchos::arrayViewFromVector(columns), Teuchos::arrayViewFromVector(values));
  }
  a.fillComplete();
  DistributedLu lu(map);
  TEST_ASSERT(lu.factor(a));
  TpetraVector x(map);
  const auto b = noise_vector(map);
  lu.apply(*b, x);
  TEST_COMPARE(relative_residual(a, *b, x), <=, 1e-13);
}

// A stone that nothing holds must not keep all others from a solution.
TEUCHOS_UNIT_TEST(DistributedLu, LeavesOutRowsThatSayNothing) {
  const int size = 60;
  const auto good = scattered(size);
  const auto a = distributed(size, good, everyone());
  const auto none = distributed(
      size,
      [&](long long row) {
        auto entries = good(row);
        for (auto& [column, value] : entries)
          if (row == 17 || column == 17) value = 0;
        return entries;
      },
      everyone());
  DistributedLu lu(a->getRowMap());
  const auto b = noise_vector(a->getRowMap());
  for (const auto& matrix : {none, a}) {
    TEST_ASSERT(lu.factor(*matrix));
    TpetraVector x(a->getRowMap()), right(*b, Teuchos::Copy);
    if (matrix == none && right.getMap()->isNodeGlobalElement(17)) right.replaceGlobalValue(17, 0.0);
    lu.apply(right, x);
    TEST_COMPARE(relative_residual(*matrix, right, x), <=, 1e-12);
  }
}

// Of a symmetric matrix half of the entries do; and one rank may factor for all.
TEUCHOS_UNIT_TEST(DistributedLu, SolvesSymmetricSystemsAndOnTheFirstRankToo) {
  const auto a = distributed(300, scattered(300), everyone()), b = distributed(300, scattered(300, 3.0), everyone());
  const auto right = noise_vector(a->getRowMap());
  for (const auto factors : {FactorsAre::spread, FactorsAre::on_first_rank})
    for (const auto symmetry : {Symmetry::symmetric, Symmetry::none}) {
      DistributedLu lu(a->getRowMap(), factors, symmetry);
      for (const auto& matrix : {a, b}) {
        TEST_ASSERT(lu.factor(*matrix));
        TpetraVector x(a->getRowMap());
        for (int times = 0; times < 2; ++times) lu.apply(*right, x);
        TEST_COMPARE(relative_residual(*matrix, *right, x), <=, 1e-12);
      }
    }
}

/// What all ranks hear of work that MUMPS refuses.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const SolverFailure& failure) {
    return failure.what();
  }
  return "nothing";
}

TEUCHOS_UNIT_TEST(DistributedLu, WhatItsLibraryRefusesIsAFailureOnAllRanks) {
  const auto a = distributed(60, scattered(60), everyone()), none = distributed(0, scattered(0), everyone());
  DistributedLu empty(none->getRowMap());
  TEST_EQUALITY(refusal([&] { return empty.factor(*none); }), "MUMPS could not factor a matrix (its status: -16)");
  DistributedLu lu(a->getRowMap());
  TpetraVector x(a->getRowMap());
  const auto b = noise_vector(a->getRowMap());
  TEST_EQUALITY(refusal([&] { lu.apply(*b, x); }), "MUMPS could not solve with its factors (its status: -3)");
  TEST_ASSERT(lu.factor(*a));  // and serves what follows
  lu.apply(*b, x);
  TEST_COMPARE(relative_residual(*a, *b, x), <=, 1e-12);
}

}  // namespace
