// Holds the main program to its word: rank 0, which reports, must say FAILED when only another rank failed.
#include <Teuchos_DefaultComm.hpp>
#include <Teuchos_UnitTestHarness.hpp>

namespace {

TEUCHOS_UNIT_TEST(UnitTestMain, AFailureOnTheLastRankIsAFailure) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  TEST_ASSERT(comm->getRank() + 1 < comm->getSize());
}

}  // namespace
