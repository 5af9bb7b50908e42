// Lists of all ranks come together, and parcels reach those they are for, in calls of any length.
#include "linalg/gather.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "linalg/parcels.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr WhyWhole a_test{"a few items of a test"};
// Bytes of a call: all at once; a few, so that an item is cut in two; one of each of four ranks.
constexpr long long lengths[] = {most_of_a_call, 37, 4};

struct Item {
  long long rank;
  double value;
  char letter;
};

int count_of(int rank) { return (3 * rank) % 4; }  // 0, 3, 2, 1: the first has none

std::vector<Item> items_of(int rank) {
  std::vector<Item> items;
  for (int k = 0; k < count_of(rank); ++k) items.push_back({rank, noise(k), char('a' + k)});
  return items;
}

/// Whether these are the items of all ranks, rank by rank.
void check_all(const std::vector<Item>& all, Teuchos::FancyOStream& out, bool& success) {
  std::size_t next = 0;
  for (int rank = 0; rank < everyone()->getSize(); ++rank)
    for (int k = 0; k < count_of(rank); ++k, ++next) {
      TEST_ASSERT(next < all.size());
      if (next >= all.size()) return;
      TEST_EQUALITY(all[next].rank, rank);
      TEST_EQUALITY(all[next].value, noise(k));
      TEST_EQUALITY(all[next].letter, char('a' + k));
    }
  TEST_EQUALITY(all.size(), next);
}

TEUCHOS_UNIT_TEST(AllGather, EveryRankHasTheItemsOfAllRankByRank) {
  for (const auto most : lengths) {
    const auto comm = everyone();
    check_all(all_gather(items_of(comm->getRank()), *comm, a_test, most), out, success);
  }
}

TEUCHOS_UNIT_TEST(AllGather, ListsOfSumsAreOfAnyLength) {
  const auto comm = everyone();
  std::vector<double> mine(11);
  for (std::size_t k = 0; k < mine.size(); ++k) mine[k] = static_cast<double>(k) * (comm->getRank() + 1);
  const int ranks = comm->getSize();
  for (const auto most : {most_of_a_call, 88LL, 25LL, 8LL}) {
    const auto all = list_over_ranks(*comm, Teuchos::REDUCE_SUM, mine, a_test, most);
    for (std::size_t k = 0; k < mine.size(); ++k)
      TEST_EQUALITY(all[k], static_cast<double>(k) * ranks * (ranks + 1) / 2);
  }
  TEST_ASSERT(total_of_list(*comm, std::vector<double>(), a_test).empty());
  TEST_EQUALITY(largest_of_list(*comm, std::vector<int>{comm->getRank()}, a_test)[0], ranks - 1);
}

TEUCHOS_UNIT_TEST(AllGather, WhatComesThroughTheDoorIsCounted) {
  const auto comm = everyone();
  const auto before = gathered_so_far();
  const std::vector<double> large(static_cast<std::size_t>(before.largest) + 1);
  constexpr WhyWhole planted{"planted"};
  all_gather(large, *comm, planted);
  if (comm->getSize() == 1) return;
  TEST_EQUALITY(gathered_so_far().lists, before.lists + 1);
  TEST_EQUALITY(gathered_so_far().largest, static_cast<long long>(8 * large.size()) * comm->getSize());
  TEST_EQUALITY(gathered_so_far().because, planted.because);
}

TEUCHOS_UNIT_TEST(GatherOnFirst, OnlyTheFirstHasThem) {
  const auto comm = everyone();
  const auto all = gather_on_first(items_of(comm->getRank()), *comm);
  if (comm->getRank() == 0)
    check_all(all, out, success);
  else
    TEST_ASSERT(all.empty());
}

// Every rank sends to some others and to itself, and none knows who sends to it; many times in turn, so that a rank
// that is ahead would be heard too early.
TEUCHOS_UNIT_TEST(Parcels, ReachThoseTheyAreForAndNobodyElse) {
  const auto comm = everyone();
  const int ranks = comm->getSize(), me = comm->getRank();
  const auto sends = [](int from, int to, int round) { return (from + 2 * to + round) % 3 != 0; };
  for (int round = 0; round < 30; ++round)
    for (const auto most : lengths) {
      std::vector<Parcel<Item>> parcels;
      for (int to = ranks - 1; to >= 0; --to)
        if (sends(me, to, round)) parcels.push_back({to, std::vector<Item>(to + 1, Item{me, noise(round), 'x'})});
      parcels.push_back({0, {}});
      const auto came = exchange_parcels(std::move(parcels), *comm, most);
      std::size_t next = 0;
      for (int from = 0; from < ranks; ++from) {
        if (!sends(from, me, round)) continue;
        TEST_ASSERT(next < came.size());
        if (next >= came.size()) return;
        const auto& parcel = came[next++];
        TEST_EQUALITY(parcel.rank, from);
        TEST_EQUALITY(parcel.items.size(), static_cast<std::size_t>(me + 1));
        for (const auto& item : parcel.items) {
          TEST_EQUALITY(item.rank, from);
          TEST_EQUALITY(item.value, noise(round));
        }
      }
      TEST_EQUALITY(next, came.size());
    }
}

TEUCHOS_UNIT_TEST(Parcels, APostKeepsTheOrderOfWhatItIsGiven) {
  const auto comm = everyone();
  Post<int> post(*comm);
  for (int k = 0; k < 10; ++k) post.add(k % comm->getSize(), 100 * comm->getRank() + k);
  std::vector<int> expected;
  for (int from = 0; from < comm->getSize(); ++from)
    for (int k = comm->getRank(); k < 10; k += comm->getSize()) expected.push_back(100 * from + k);
  TEST_COMPARE_ARRAYS(std::move(post).send_all(), expected);
}

}  // namespace
