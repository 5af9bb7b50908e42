// A unit test that passes and loses memory: under the sanitizers the main program must find that.
#include <Teuchos_UnitTestHarness.hpp>

namespace {

double* volatile kept = nullptr;

TEUCHOS_UNIT_TEST(UnitTestMain, AMemoryLossIsFound) {
  for (int k = 0; k < 100; ++k) kept = new double[1000];  // the last one is still reachable
  TEST_ASSERT(kept != nullptr);
}

}  // namespace
