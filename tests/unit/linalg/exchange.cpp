// Ghost values follow their owners.
#include "linalg/exchange.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Rank r owns r + 2 numbers (rank 1 of several owns none), scattered; everyone has ghosts of all others, last first.
struct Numbers {
  std::vector<long long> local;
  int owned = 0;

  Numbers() {
    const auto comm = everyone();
    std::vector<long long> others;
    long long next = 0;
    for (int rank = 0; rank < comm->getSize(); ++rank)
      for (int k = 0; k < (rank == 1 ? 0 : rank + 2); ++k) {
        const long long id = 3 * next++ + 5;  // gaps, so that a number is not its place
        (rank == comm->getRank() ? local : others).push_back(id);
      }
    owned = static_cast<int>(local.size());
    local.insert(local.end(), others.rbegin(), others.rend());
  }
};

TEUCHOS_UNIT_TEST(Exchange, GhostsTakeTheValuesOfTheirOwners) {
  const Numbers numbers;
  const Exchange exchange(numbers.local, numbers.owned, everyone());
  TEST_EQUALITY(exchange.owned(), numbers.owned);
  const int rows = static_cast<int>(numbers.local.size());
  std::vector<double> values(3 * rows, -1.0);
  for (int i = 0; i < numbers.owned; ++i)
    for (int c = 0; c < 3; ++c) values[3 * i + c] = noise(numbers.local[i]) + c;
  exchange.update(values, 3);
  for (int i = 0; i < rows; ++i)
    for (int c = 0; c < 3; ++c) TEST_EQUALITY(values[3 * i + c], noise(numbers.local[i]) + c);
}

TEUCHOS_UNIT_TEST(Exchange, WholeNumbersUpTo2To53ArriveUnchanged) {
  const Numbers numbers;
  const Exchange exchange(numbers.local, numbers.owned, everyone());
  const long long huge = 1LL << 53;
  const auto value = [huge](long long id) { return id % 2 ? huge - id : id - huge; };
  std::vector<long long> values(numbers.local.size(), 0);
  for (int i = 0; i < numbers.owned; ++i) values[i] = value(numbers.local[i]);
  exchange.update(values);
  for (std::size_t i = 0; i < values.size(); ++i) TEST_EQUALITY(values[i], value(numbers.local[i]));
}

}  // namespace
