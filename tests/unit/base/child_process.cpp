// Work in a process of its own: what it returns, what it throws, and how it dies.
#include "base/child_process.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <unistd.h>

#include <csignal>

#include "base/error.hpp"

namespace voussoir {
namespace {

void nothing(const std::string&) {}

TEUCHOS_UNIT_TEST(ChildProcess, ReturnsBytesOfAnyNumber) {
  const std::string long_text(3'000'001, 'v');  // many times what a pipe holds
  TEST_ASSERT(in_child_process([&] { return long_text; }, nothing) == long_text);
  TEST_EQUALITY(in_child_process([] { return std::string("a\0b", 3); }, nothing), std::string("a\0b", 3));
  TEST_EQUALITY(in_child_process([] { return std::string(); }, nothing), "");
}

TEUCHOS_UNIT_TEST(ChildProcess, LeavesThisOneAsItWas) {
  int number = 1;
  in_child_process([&] { return std::to_string(++number); }, nothing);
  TEST_EQUALITY(number, 1);
}

TEUCHOS_UNIT_TEST(ChildProcess, ThrowsHereWhatIsThrownThere) {
  const auto message = [](const std::function<std::string()>& work) -> std::string {
    try {
      in_child_process(work, nothing);
    } catch (const InputError& error) {
      return std::string("input: ") + error.what();
    } catch (const ResourceError& error) {
      return std::string("resource: ") + error.what();
    }
    return "";
  };
  TEST_EQUALITY(message([]() -> std::string { throw InputError("a.msh is empty"); }), "input: a.msh is empty");
  TEST_EQUALITY(message([]() -> std::string { throw ResourceError("disk full"); }), "resource: disk full");
  TEST_EQUALITY(message([]() -> std::string { throw std::runtime_error("odd"); }), "resource: odd");
}

TEUCHOS_UNIT_TEST(ChildProcess, TellsOfItsDeath) {
  std::string how;
  const auto died = [&](const std::string& signal) { throw InputError(how = signal); };
  for (const int signal : {SIGSEGV, SIGKILL})
    TEST_THROW(in_child_process([&]() -> std::string { std::raise(signal); return ""; }, died), InputError);
  TEST_EQUALITY(how, "Killed");
  TEST_THROW(in_child_process([]() -> std::string { _exit(3); }, nothing), ResourceError);
}

}  // namespace
}  // namespace voussoir
