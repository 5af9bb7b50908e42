// One number of all ranks from one number of each, or each of a list of numbers. All functions are collective, and what
// they return is the same on every rank.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <limits>

#include "base/check.hpp"

namespace voussoir {

template <class T>
T total_over_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

template <class T>
T largest_over_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
  return all;
}

template <class T>
T least_over_ranks(const Teuchos::Comm<int>& comm, T mine) {
  T all(0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(all));
  return all;
}

inline bool any_of_ranks(const Teuchos::Comm<int>& comm, bool mine) { return largest_over_ranks(comm, int(mine)) > 0; }
inline bool all_of_ranks(const Teuchos::Comm<int>& comm, bool mine) { return least_over_ranks(comm, int(mine)) > 0; }

/// @param mine  a vector or an array of numbers, of the same length on every rank
template <class List>
List each_over_ranks(const Teuchos::Comm<int>& comm, Teuchos::EReductionType how, const List& mine) {
  VOUSSOIR_EXPECT(mine.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()));
  List all = mine;
  Teuchos::reduceAll(comm, how, static_cast<int>(mine.size()), mine.data(), all.data());
  return all;
}

template <class List>
List total_of_each(const Teuchos::Comm<int>& comm, const List& mine) {
  return each_over_ranks(comm, Teuchos::REDUCE_SUM, mine);
}

template <class List>
List largest_of_each(const Teuchos::Comm<int>& comm, const List& mine) {
  return each_over_ranks(comm, Teuchos::REDUCE_MAX, mine);
}

template <class List>
List least_of_each(const Teuchos::Comm<int>& comm, const List& mine) {
  return each_over_ranks(comm, Teuchos::REDUCE_MIN, mine);
}

}  // namespace voussoir
