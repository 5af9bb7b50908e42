// What all ranks hold, brought together on every rank.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <numeric>
#include <type_traits>
#include <vector>

namespace voussoir {

/// The items of all ranks, rank by rank, the same on every rank. For plain data of moderate size.
template <class T>
std::vector<T> all_gather(const std::vector<T>& mine, const Teuchos::Comm<int>& comm) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (comm.getSize() == 1) return mine;
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(comm.getSize());
  Teuchos::gatherAll(comm, 1, &count, comm.getSize(), counts.data());
  const int total = std::accumulate(counts.begin(), counts.end(), 0);
  std::vector<T> all(total);
  int first = 0;
  for (int rank = 0; rank < comm.getSize(); ++rank) {
    if (rank == comm.getRank()) std::copy(mine.begin(), mine.end(), all.begin() + first);
    const int bytes = counts[rank] * static_cast<int>(sizeof(T));
    Teuchos::broadcast(comm, rank, bytes, reinterpret_cast<char*>(all.data() + first));
    first += counts[rank];
  }
  return all;
}

}  // namespace voussoir
