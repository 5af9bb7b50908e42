// What hangs together across ranks, and sums over it, where no rank knows all of it.
#pragma once

#include <Teuchos_Comm.hpp>
#include <array>
#include <map>
#include <vector>

#include "linalg/parcels.hpp"

namespace voussoir {

/// A thing of this rank that hangs together with one of this or of another rank.
struct HangsWith {
  long long mine, other;
  int owner_of_other;
};

/// The least number of the things each thing hangs together with, over as many others as it takes; its own where it
/// hangs with none. Ranks tell their neighbours until nothing changes: as often as the way from the least thing of a
/// group to its others leads from rank to rank. Collective.
/// @param mine   things of this rank, ascending
/// @param pairs  each is known to the ranks of both
std::vector<long long> least_of_group(const std::vector<long long>& mine, const std::vector<HangsWith>& pairs,
                                      const Teuchos::Comm<int>&);

/// Sums of what several ranks have parts of: each hands in what it has by key, and hears the totals of these keys.
/// Parts are added in the order of ranks. Collective.
template <std::size_t n>
std::map<long long, std::array<double, n>> totals_by_key(const std::map<long long, std::array<double, n>>& mine,
                                                         const Teuchos::Comm<int>& comm) {
  struct Row {
    long long key;
    std::array<double, n> sum;
  };
  Post<Row> hand_in(comm);
  for (const auto& [key, sum] : mine) hand_in.add(static_cast<int>(key % comm.getSize()), {key, sum});
  const auto came = std::move(hand_in).send();
  std::map<long long, std::array<double, n>> totals;
  for (const auto& parcel : came)
    for (const auto& row : parcel.items) {
      auto& total = totals[row.key];
      for (std::size_t c = 0; c < n; ++c) total[c] += row.sum[c];
    }
  Post<Row> answer(comm);
  for (const auto& parcel : came)
    for (const auto& row : parcel.items) answer.add(parcel.rank, {row.key, totals.at(row.key)});
  std::map<long long, std::array<double, n>> heard;
  for (const auto& row : std::move(answer).send_all()) heard[row.key] = row.sum;
  return heard;
}

}  // namespace voussoir
