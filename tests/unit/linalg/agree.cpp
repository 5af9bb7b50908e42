// Numbers of all ranks, and errors on which all agree.
#include "linalg/agree.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <array>

#include "linalg/reduce.hpp"

namespace {

using namespace voussoir;

struct World {
  Teuchos::RCP<const Teuchos::Comm<int>> comm = Tpetra::getDefaultComm();
  int rank = comm->getRank(), ranks = comm->getSize(), last = ranks - 1;
};

TEUCHOS_UNIT_TEST(Reduce, NumbersOfAllRanks) {
  const World w;
  TEST_EQUALITY(total_over_ranks(*w.comm, w.rank + 1), w.ranks * (w.ranks + 1) / 2);
  TEST_EQUALITY(largest_over_ranks(*w.comm, -1.5 - w.rank), -1.5);
  TEST_EQUALITY(least_over_ranks(*w.comm, 7LL - w.rank), 7LL - w.last);
  TEST_ASSERT(any_of_ranks(*w.comm, w.rank == w.last));
  TEST_ASSERT(!any_of_ranks(*w.comm, false));
  TEST_EQUALITY(all_of_ranks(*w.comm, w.rank < 1), w.ranks == 1);
  TEST_ASSERT(all_of_ranks(*w.comm, true));
}

TEUCHOS_UNIT_TEST(Reduce, EachOfAList) {
  const World w;
  const std::vector<long long> mine{1, w.rank, -w.rank};
  TEST_COMPARE_ARRAYS(total_of_each(*w.comm, mine),
                      (std::vector<long long>{w.ranks, w.ranks * w.last / 2, -w.ranks * w.last / 2}));
  TEST_COMPARE_ARRAYS(largest_of_each(*w.comm, mine), (std::vector<long long>{1, w.last, 0}));
  TEST_COMPARE_ARRAYS(least_of_each(*w.comm, mine), (std::vector<long long>{1, 0, -w.last}));
  const std::array<double, 2> pair{0.5, -0.5 * w.rank};
  TEST_EQUALITY(least_of_each(*w.comm, pair)[1], -0.5 * w.last);
  TEST_ASSERT(total_of_each(*w.comm, std::vector<double>{}).empty());
}

/// What a rank is told of work, and as which error.
template <class Work>
std::string told(const World& w, const Work& work) {
  try {
    agree(*w.comm, work);
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  } catch (const ResourceError& error) {
    return std::string("resource: ") + error.what();
  }
  return "";
}

TEUCHOS_UNIT_TEST(Agree, EveryRankThrowsWhatTheFirstThatFailsWould) {
  const World w;
  const std::string last = "rank " + std::to_string(w.last);
  TEST_EQUALITY(told(w, [] {}), "");
  // Texts of different lengths, on every rank but the first and on the last alone.
  TEST_EQUALITY(told(w,
                     [&] {
                       if (w.rank > 0 || w.ranks == 1) throw InputError("r" + std::string(w.rank, '!'));
                     }),
                w.ranks == 1 ? "input: r" : "input: r!");
  TEST_EQUALITY(told(w,
                     [&] {
                       if (w.rank == w.last) throw std::runtime_error(last);
                     }),
                "resource: " + last);
  TEST_EQUALITY(told(w, [&] { throw ConvergenceError(""); }), "resource: ");
  TEST_EQUALITY(told(w, [&] { throw std::bad_alloc(); }), std::string("resource: ") + out_of_memory_message);
}

TEUCHOS_UNIT_TEST(Agree, TheFirstRankWorksForAll) {
  const World w;
  int calls = 0;
  on_first_rank(*w.comm, [&] { ++calls; });
  TEST_EQUALITY(calls, w.rank == 0 ? 1 : 0);
  TEST_THROW(on_first_rank(*w.comm, [] { throw InputError("no such file"); }), InputError);
  std::vector<std::string> words;
  if (w.rank == 0) words = {"", "a word"};
  broadcast_strings(*w.comm, words);
  TEST_COMPARE_ARRAYS(words, (std::vector<std::string>{"", "a word"}));
}

}  // namespace
