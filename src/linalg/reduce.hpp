// One number of all ranks from one number of each.
#pragma once

#include <Teuchos_CommHelpers.hpp>

namespace voussoir {

/// Sum over the ranks, the same on every rank. Collective.
template <class T>
T total_over_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

/// Largest over the ranks, the same on every rank. Collective.
inline double largest_over_ranks(const Teuchos::Comm<int>& comm, double mine) {
  double all = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
  return all;
}

}  // namespace voussoir
