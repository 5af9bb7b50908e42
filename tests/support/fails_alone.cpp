// Holds a failure that nobody foresaw to its word: where a library throws on one rank alone, that rank says what, and
// the job ends, while the other waits for it.
#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <stdexcept>

#include "linalg/fail_together.hpp"

namespace {

TEUCHOS_UNIT_TEST(FailTogether, AFailureOfOneRankEndsTheJob) {
  const auto comm = Tpetra::getDefaultComm();
  voussoir::fail_together(*comm, [&] {
    if (comm->getRank() + 1 == comm->getSize()) throw std::logic_error("a level has no rows");
    comm->barrier();  // for the other, which does not come
  });
  TEST_ASSERT(false);
}

}  // namespace
