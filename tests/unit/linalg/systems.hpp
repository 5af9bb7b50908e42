// Linear systems and communicators that several tests share.
#pragma once

#include <Teuchos_DefaultComm.hpp>
#include <cmath>
#include <functional>
#include <map>

#include "linalg/local_csr.hpp"
#include "linalg/local_view.hpp"

namespace voussoir::test {

using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

inline Comm everyone() { return Teuchos::DefaultComm<int>::getComm(); }

/// A communicator of this rank alone, for the answer of one rank.
inline Comm alone() { return everyone()->split(everyone()->getRank(), 0); }

template <class T>
T sum_over_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all{};
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

template <class T>
T largest_of_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all{};
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
  return all;
}

/// A number in (-1, 1) that looks random and is the same everywhere.
inline double noise(long long i) {
  const double x = std::sin(12.9898 * double(i + 1)) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}

using Rows = std::function<std::map<long long, double>(long long row)>;

/// Two fields on n x n nodes with the five-point Laplacian each, held beyond the border and coupled by 0.05 at every
/// node: positive definite up to n = 18, where the Laplacian's smallest eigenvalue is still 0.055. Unknown 2 node + c.
inline Rows coupled_laplacian(int n) {
  return [n](long long row) {
    const long long node = row / 2, c = row % 2, i = node % n, j = node / n;
    std::map<long long, double> entries{{row, 4.0}, {2 * node + 1 - c, 0.05}};
    if (i > 0) entries[row - 2] = -1;
    if (i < n - 1) entries[row + 2] = -1;
    if (j > 0) entries[row - 2 * n] = -1;
    if (j < n - 1) entries[row + 2 * n] = -1;
    return entries;
  };
}

/// A symmetric positive definite matrix whose rows have entries at odd places; diagonally dominant by 0.1.
inline Rows scattered(long long size, double scale = 1.0) {
  return [size, scale](long long row) {
    std::map<long long, double> entries;
    for (long long stride : {1LL, 7LL, 30LL})
      for (long long other : {row - stride, row + stride})
        if (other >= 0 && other < size) entries[other] = scale * noise(std::min(row, other) + 1000 * stride);
    double dominance = 0.1 * scale;
    for (const auto& [column, value] : entries) dominance += std::abs(value);
    entries[row] = dominance;
    return entries;
  };
}

inline Teuchos::RCP<TpetraMatrix> distributed(long long size, const Rows& rows, const Comm& comm) {
  const auto map = Teuchos::rcp(new TpetraMap(Tpetra::global_size_t(size), 0, comm));
  auto a = Teuchos::rcp(new TpetraMatrix(map, 16));
  for (const long long row : map->getNodeElementList()) {
    std::vector<GlobalOrdinal> columns;
    std::vector<double> values;
    for (const auto& [column, value] : rows(row)) {
      columns.push_back(column);
      values.push_back(value);
    }
    a->insertGlobalValues(row, Teuchos::arrayViewFromVector(columns), Teuchos::arrayViewFromVector(values));
  }
  a->fillComplete();
  return a;
}

inline LocalCsr local(int size, const Rows& rows) {
  LocalCsr a;
  for (int row = 0; row < size; ++row) {
    for (const auto& [column, value] : rows(row)) {
      a.column.push_back(static_cast<int>(column));
      a.value.push_back(value);
    }
    a.start.push_back(static_cast<int>(a.column.size()));
  }
  return a;
}

/// noise() at every unknown, the same vector for any number of ranks.
inline Teuchos::RCP<TpetraVector> noise_vector(const Teuchos::RCP<const TpetraMap>& map) {
  auto v = Teuchos::rcp(new TpetraVector(map));
  double* value = local_view_to_write(*v);
  for (const auto i : map->getNodeElementList()) *value++ = noise(i);
  return v;
}

/// |b - A x| / |b|
inline double relative_residual(const TpetraOperator& a, const TpetraVector& b, const TpetraVector& x) {
  TpetraVector r(b.getMap());
  a.apply(x, r);
  r.update(1.0, b, -1.0);
  return r.norm2() / b.norm2();
}

}  // namespace voussoir::test
