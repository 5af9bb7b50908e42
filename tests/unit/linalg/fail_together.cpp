// The exit code after what nobody foresaw; support.fails_alone holds the end of a job of several ranks.
#include "linalg/fail_together.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <new>
#include <stdexcept>

namespace {

template <class Thrown>
int exit_after(const Thrown& thrown) {
  const Teuchos::SerialComm<int> alone;
  try {
    voussoir::fail_together(alone, [&] { throw thrown; });
  } catch (...) {
    return voussoir::end_unforeseen(alone);
  }
  return voussoir::exit_done;
}

TEUCHOS_UNIT_TEST(FailTogether, WhateverALibraryThrowsHasAnExitCode) {
  TEST_EQUALITY(exit_after(std::logic_error("a level has no rows")), voussoir::exit_failed);
  TEST_EQUALITY(exit_after(7), voussoir::exit_failed);
  TEST_EQUALITY(exit_after(std::string("no words of the standard library")), voussoir::exit_failed);
  TEST_EQUALITY(exit_after(std::bad_alloc()), voussoir::exit_resource);
}

}  // namespace
