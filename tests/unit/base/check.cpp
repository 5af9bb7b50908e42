// Contracts hold in every build: a broken one says where it is and what does not hold.
#include "base/check.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <functional>
#include <stdexcept>

namespace {

std::string complaint(const std::function<void(int)>& contract) {
  try {
    contract(-1);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

TEUCHOS_UNIT_TEST(Check, ABrokenContractIsNoticedInEveryBuild) {
  const auto says = [&](const std::function<void(int)>& contract, const std::string& kind) {
    contract(1);
    const std::string said = complaint(contract);
    TEST_ASSERT(said.find("check.cpp:") != std::string::npos);
    TEST_ASSERT(said.find(kind + " does not hold: number > 0") != std::string::npos);
  };
  says([](int number) { VOUSSOIR_EXPECT(number > 0); }, "precondition");
  says([](int number) { VOUSSOIR_ASSERT(number > 0); }, "assertion");
  says([](int number) { VOUSSOIR_ENSURE(number > 0); }, "postcondition");
  says([](int number) { VOUSSOIR_CHECK(number > 0); }, "check");
}

}  // namespace
