// What a run says while it goes.
#include "results/narrator.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <chrono>
#include <sstream>
#include <string>
#include <thread>

namespace {

using namespace voussoir;

TEUCHOS_UNIT_TEST(Narrator, WhoWaitsIsToldWhatIsKnownAndHowLongTheRunHasBeenAtIt) {
  std::ostringstream said;
  Narrator narrator(said, false, 100);  // seconds that have passed before
  narrator.begin(3, "load factor", 0.4, 1);
  narrator.know("it stands at 0.375");
  narrator.solve({});
  TEST_ASSERT(said.str().find("linear solves so far") == std::string::npos);  // not yet
  std::this_thread::sleep_for(std::chrono::milliseconds(5100));
  narrator.solve({});
  narrator.solve({});
  const auto text = said.str();
  const auto at = text.find("105 s: step 3, stage 'load factor' at 0.4: 2 linear solves so far, ");
  TEST_ASSERT(at != std::string::npos);
  TEST_ASSERT(text.find("; it stands at 0.375\n", at) != std::string::npos);
  TEST_EQUALITY(text.find("so far", at), text.rfind("so far"));  // once in a while
}

TEUCHOS_UNIT_TEST(Narrator, ALongLineIsNotCut) {
  std::ostringstream said;
  Narrator narrator(said, false, 0);
  const std::string stage(1000, 'x');
  narrator.failed({}, stage, 0.5);
  TEST_ASSERT(said.str().find(stage + "' at 0.5: stopped\n") != std::string::npos);
}

}  // namespace
