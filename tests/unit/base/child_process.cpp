// Work in a process of its own: what it returns, what it throws, and how it dies.
#include "base/child_process.hpp"

#include <mpi.h>
#include <unistd.h>
#include <Teuchos_UnitTestHarness.hpp>

#include <csignal>
#include <fstream>

#include "base/error.hpp"

namespace voussoir {
namespace {

void nothing(const std::string&) {}

std::string echo(const std::string& request) { return request; }

TEUCHOS_UNIT_TEST(ChildProcess, ReturnsBytesOfAnyNumber) {
  const std::string long_text(3'000'001, 'v');  // many times what a socket holds
  TEST_ASSERT(in_child_process(echo, long_text, nothing) == long_text);
  TEST_EQUALITY(in_child_process(echo, std::string("a\0b", 3), nothing), std::string("a\0b", 3));
  TEST_EQUALITY(in_child_process(echo, "", nothing), "");
}

// A process that uses MPI must not be copied: the child is a copy of this one as it was before.
int number = 1;
TEUCHOS_UNIT_TEST(ChildProcess, IsACopyFromBeforeMpi) {
  number = 2;
  const auto work = [](const std::string&) {
    int initialised = -1;
    MPI_Initialized(&initialised);
    return std::to_string(initialised) + " " + std::to_string(number++);
  };
  for (int k = 0; k < 2; ++k) TEST_EQUALITY(in_child_process(work, "", nothing), "0 1");
  TEST_EQUALITY(number, 2);
}

TEUCHOS_UNIT_TEST(ChildProcess, ThrowsHereWhatIsThrownThere) {
  const auto message = [](ChildWork work) -> std::string {
    try {
      in_child_process(work, "", nothing);
    } catch (const InputError& error) {
      return std::string("input: ") + error.what();
    } catch (const ResourceError& error) {
      return std::string("resource: ") + error.what();
    }
    return "";
  };
  TEST_EQUALITY(message([](auto&) -> std::string { throw InputError("a.msh is empty"); }), "input: a.msh is empty");
  TEST_EQUALITY(message([](auto&) -> std::string { throw ResourceError("disk full"); }), "resource: disk full");
  TEST_EQUALITY(message([](auto&) -> std::string { throw std::runtime_error("odd"); }), "resource: odd");
}

TEUCHOS_UNIT_TEST(ChildProcess, TellsOfItsDeathAndTheNextOneWorks) {
  std::string how;
  const auto died = [&](const std::string& signal) { throw InputError(how = signal); };
  const auto raised = [](const std::string& signal) -> std::string {
    std::raise(std::stoi(signal));
    return "";
  };
  for (const int signal : {SIGSEGV, SIGTERM, SIGKILL})
    TEST_THROW(in_child_process(raised, std::to_string(signal), died), InputError);
  TEST_EQUALITY(how, "Killed");
  TEST_THROW(in_child_process([](auto&) -> std::string { _exit(3); }, "", nothing), ResourceError);
  TEST_EQUALITY(in_child_process(echo, "goes on", nothing), "goes on");
}

/// Whether a process is there and is more than an entry in a table.
bool lives(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string number_of, name, state;
  return file >> number_of >> name >> state && state != "Z";
}

// The process that waits ends with its program: here a child is the program, and its end is that of a killed one.
TEUCHOS_UNIT_TEST(ChildProcess, NobodyIsLeftBehind) {
  const auto work = [](const std::string&) {
    begin_child_processes();
    return in_child_process([](auto&) { return std::to_string(getppid()); }, "", nothing);
  };
  const std::string waiting = in_child_process(work, "", nothing);
  TEST_INEQUALITY(waiting, std::to_string(getpid()));
  for (int tenths = 0; tenths < 100 && lives(waiting); ++tenths) usleep(100'000);
  TEST_ASSERT(!lives(waiting));
}

// A library that is used without that is used all the same.
TEUCHOS_UNIT_TEST(ChildProcess, AProgramThatHasBegunNoneWorksItself) {
  const auto work = [](const std::string&) {  // nothing is begun in a child
    return in_child_process([](auto&) { return std::to_string(getpid()); }, "", nothing) + " " +
           std::to_string(getpid());
  };
  const std::string both = in_child_process(work, "", nothing);
  const std::size_t blank = both.find(' ');
  TEST_EQUALITY(both.substr(0, blank), both.substr(blank + 1));
}

}  // namespace
}  // namespace voussoir
