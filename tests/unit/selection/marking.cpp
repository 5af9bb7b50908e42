// Bulk marking against its definition: the fewest points that hold the share, the same for any distribution.
#include "selection/marking.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <numeric>

#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Deals values out to the ranks, unevenly: every fifth to the first rank, the others in turn.
std::vector<std::size_t> dealt_to_me(std::size_t count) {
  const auto comm = everyone();
  std::vector<std::size_t> mine;
  for (std::size_t k = 0; k < count; ++k)
    if (comm->getRank() == (k % 5 == 0 ? 0 : int(k) % comm->getSize())) mine.push_back(k);
  return mine;
}

/// Marks of all values, the same on every rank.
std::vector<char> marks(const std::vector<double>& eta, double share) {
  const auto mine = dealt_to_me(eta.size());
  std::vector<double> dealt;
  for (const auto k : mine) dealt.push_back(eta[k]);
  const auto marked = mark_bulk(dealt, share, *everyone());
  std::vector<int> here(eta.size(), 0), all(eta.size(), 0);
  for (std::size_t i = 0; i < mine.size(); ++i) here[mine[i]] = marked[i];
  Teuchos::reduceAll(*everyone(), Teuchos::REDUCE_SUM, int(eta.size()), here.data(), all.data());
  return {all.begin(), all.end()};
}

/// The fewest values that hold the share, by sorting.
std::vector<char> fewest(const std::vector<double>& eta, double share) {
  std::vector<std::size_t> order(eta.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&eta](std::size_t a, std::size_t b) { return eta[a] > eta[b]; });
  const double total = std::accumulate(eta.begin(), eta.end(), 0.0);
  std::vector<char> marked(eta.size(), 0);
  double sum = 0;
  for (const auto k : order) {
    if (sum >= share * total) break;
    marked[k] = 1;
    sum += eta[k];
  }
  return marked;
}

/// Values that span the given number of decades, all different; shares below hit no sum within round-off.
std::vector<double> spread(int count, double decades) {
  std::vector<double> eta;
  for (int k = 0; k < count; ++k) eta.push_back(std::pow(10.0, decades * noise(k) / 2));
  return eta;
}

TEUCHOS_UNIT_TEST(MarkBulk, MarksTheFewestPointsThatHoldTheShare) {
  for (const double decades : {0.5, 4.0, 15.0})
    for (const double share : {0.01, 0.3, 0.5, 0.9, 0.999}) {
      const auto eta = spread(200, decades);
      TEST_ASSERT(marks(eta, share) == fewest(eta, share));
    }
}

TEUCHOS_UNIT_TEST(MarkBulk, ScaleDoesNotMatter) {
  auto eta = spread(100, 4.0);
  const auto expected = marks(eta, 0.7);
  for (const double scale : {1e-200, 1e200}) {
    auto scaled = eta;
    for (double& e : scaled) e *= scale;
    TEST_ASSERT(marks(scaled, 0.7) == expected);
  }
}

TEUCHOS_UNIT_TEST(MarkBulk, EqualPointsAreMarkedTogether) {
  // Whoever owns them: choosing among equals would make the answer depend on ranks.
  const std::vector<double> eta{1, 2, 2, 2, 1, 2, 0, 1};
  TEST_ASSERT(marks(eta, 0.3) == (std::vector<char>{0, 1, 1, 1, 0, 1, 0, 0}));
  TEST_ASSERT(marks(eta, 0.9) == (std::vector<char>{1, 1, 1, 1, 1, 1, 0, 1}));
}

TEUCHOS_UNIT_TEST(MarkBulk, AShareOfOneMarksAllThatIsPositiveAndNothingElse) {
  const std::vector<double> eta{1e-300, 0, 1, 0, 5e3, 1e-17, 0};
  TEST_ASSERT(marks(eta, 1.0) == (std::vector<char>{1, 0, 1, 0, 1, 1, 0}));
}

TEUCHOS_UNIT_TEST(MarkBulk, ASinglePointIsMarkedForAnyShareAndZerosNever) {
  for (const double share : {1e-6, 0.5, 1.0}) {
    TEST_ASSERT(marks({0, 0, 3, 0, 0}, share) == (std::vector<char>{0, 0, 1, 0, 0}));
    TEST_ASSERT(marks({0, 0, 0, 0, 0}, share) == std::vector<char>(5, 0));
    TEST_ASSERT(marks({}, share).empty());
  }
}

}  // namespace
