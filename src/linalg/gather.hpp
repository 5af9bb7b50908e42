// What all ranks hold, brought together on every rank: the one door for lists that may have the size of the structure.
//
// A list that grows with the structure and stands whole on every rank ends scaling: in memory, in bytes sent, or both.
// So every caller says here why its list may. tests/house/gathering.py knows the callers, and refuses others.
// What goes to single ranks goes by parcels (parcels.hpp), what has a fixed length by reduce.hpp.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace voussoir {

/// Why a list may stand whole on every rank.
struct WhyWhole {
  const char* because;
};

/// Bytes that a call of MPI takes, which counts in ints.
constexpr long long most_of_a_call = std::numeric_limits<int>::max();

/// What has come through the door since the program began, of lists in bytes.
struct Gathered {
  long long lists = 0, largest = 0;
  const char* because = "";  ///< of the largest
};
const Gathered& gathered_so_far();

/// What is behind the door.
namespace gathering {

/// One number of each rank. Collective.
std::vector<long long> of_each_rank(long long mine, const Teuchos::Comm<int>&);
/// Bytes of all ranks, rank by rank, in as many calls as it takes. Collective.
/// @param sizes  of each rank [bytes]
void bring_together(const char* mine, const std::vector<long long>& sizes, char* all, const Teuchos::Comm<int>&,
                    long long most);
void count(long long bytes, WhyWhole);

}  // namespace gathering

/// The items of all ranks, rank by rank, the same on every rank. For plain data. Collective.
/// @param most  bytes of a call of MPI
template <class T>
std::vector<T> all_gather(const std::vector<T>& mine, const Teuchos::Comm<int>& comm, WhyWhole why,
                          long long most = most_of_a_call) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (comm.getSize() == 1) return mine;
  const auto sizes = gathering::of_each_rank(static_cast<long long>(mine.size() * sizeof(T)), comm);
  const auto bytes = std::accumulate(sizes.begin(), sizes.end(), 0LL);
  gathering::count(bytes, why);
  std::vector<T> all(static_cast<std::size_t>(bytes) / sizeof(T));
  gathering::bring_together(reinterpret_cast<const char*>(mine.data()), sizes, reinterpret_cast<char*>(all.data()),
                            comm, most);
  return all;
}

/// Each number of a list over all ranks, the same on every rank. Collective.
/// @param mine  of the same length on every rank
template <class T>
std::vector<T> list_over_ranks(const Teuchos::Comm<int>& comm, Teuchos::EReductionType how, const std::vector<T>& mine,
                               WhyWhole why, long long most = most_of_a_call) {
  auto all = mine;
  if (comm.getSize() == 1) return all;
  const auto length = static_cast<long long>(mine.size()), portion = most / static_cast<long long>(sizeof(T));
  gathering::count(length * static_cast<long long>(sizeof(T)), why);
  for (long long from = 0; from < length; from += portion)
    Teuchos::reduceAll(comm, how, static_cast<int>(std::min(portion, length - from)), mine.data() + from,
                       all.data() + from);
  return all;
}

template <class T>
std::vector<T> total_of_list(const Teuchos::Comm<int>& comm, const std::vector<T>& mine, WhyWhole why) {
  return list_over_ranks(comm, Teuchos::REDUCE_SUM, mine, why);
}

template <class T>
std::vector<T> largest_of_list(const Teuchos::Comm<int>& comm, const std::vector<T>& mine, WhyWhole why) {
  return list_over_ranks(comm, Teuchos::REDUCE_MAX, mine, why);
}

}  // namespace voussoir
