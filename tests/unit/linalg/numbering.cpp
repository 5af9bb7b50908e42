// Numbers, groups and sums of which every rank knows its own part alone.
#include "linalg/numbering.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "base/disjoint_sets.hpp"
#include "linalg/groups.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// So many things dealt out among ranks by lot, the same on every rank.
std::vector<int> owners(int things, unsigned seed) {
  std::mt19937 lot(seed);
  std::vector<int> owner;
  for (int k = 0; k < things; ++k)
    owner.push_back(static_cast<int>(lot() % static_cast<unsigned>(everyone()->getSize())));
  return owner;
}

TEUCHOS_UNIT_TEST(Numbering, FirstNumbersAreThoseOfOneRank) {
  for (const int things : {1, 3, 40}) {
    const auto owner = owners(things, 7);
    std::mt19937 lot(things);
    std::vector<long long> count, first{0};
    for (int k = 0; k < things; ++k) count.push_back(static_cast<long long>(lot() % 5));  // some have none
    for (const auto n : count) first.push_back(first.back() + n);
    std::vector<long long> asked, mine;
    for (int k = 0; k < things; ++k)
      if (owner[k] == everyone()->getRank()) asked.push_back(k), mine.push_back(count[k]);
    for (int k = things; k-- > 0;)
      if (owner[k] != everyone()->getRank() && k % 3 > 0) asked.push_back(k);
    const auto numbers = first_numbers(asked, mine, things, *everyone());
    TEST_EQUALITY(numbers.total, first.back());
    TEST_EQUALITY(numbers.first.size(), asked.size());
    for (std::size_t k = 0; k < asked.size(); ++k) TEST_EQUALITY(numbers.first[k], first[asked[k]]);
  }
}

TEUCHOS_UNIT_TEST(Groups, HangTogetherOverAnyNumberOfRanks) {
  constexpr int things = 60;
  for (const int pairs : {0, 20, 45, 59, 120}) {
    const auto owner = owners(things, 11);
    std::mt19937 lot(pairs);
    DisjointSets all(things);
    std::vector<HangsWith> mine;
    for (int n = 0; n < pairs; ++n) {
      // A chain where there are as many pairs as it has links, in which every link may lead to another rank.
      const int a = pairs == things - 1 ? n : static_cast<int>(lot() % things);
      const int b = pairs == things - 1 ? n + 1 : static_cast<int>(lot() % things);
      all.unite(a, b);
      if (owner[a] == everyone()->getRank()) mine.push_back({a, b, owner[b]});
      if (owner[b] == everyone()->getRank()) mine.push_back({b, a, owner[a]});
    }
    std::vector<long long> own;
    for (int k = 0; k < things; ++k)
      if (owner[k] == everyone()->getRank()) own.push_back(k);
    const auto least = least_of_group(own, mine, *everyone());
    TEST_EQUALITY(least.size(), own.size());
    for (std::size_t k = 0; k < own.size(); ++k) TEST_EQUALITY(least[k], all.root(static_cast<int>(own[k])));
  }
}

TEUCHOS_UNIT_TEST(Groups, SumsComeToThoseWhoHaveAPart) {
  const int me = everyone()->getRank(), ranks = everyone()->getSize();
  std::map<long long, std::array<double, 2>> mine;
  for (int key = me; key < me + 3; ++key) mine[key] = {1.0 + me, 1};
  const auto total = totals_by_key(mine, *everyone());
  TEST_EQUALITY(total.size(), 3u);
  for (const auto& [key, sum] : total) {
    double expected = 0, parts = 0;
    for (int rank = 0; rank < ranks; ++rank)
      if (rank <= key && key < rank + 3) expected += 1.0 + rank, ++parts;
    TEST_EQUALITY(sum[0], expected);
    TEST_EQUALITY(sum[1], parts);
  }
}

}  // namespace
