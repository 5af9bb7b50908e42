// Work in a process of its own: what it returns, what it throws, and how it dies.
#include "base/child_process.hpp"

#include <mpi.h>
#include <unistd.h>
#include <Teuchos_UnitTestHarness.hpp>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/error.hpp"
#include "base/free_memory.hpp"

namespace voussoir {
namespace {

void nothing(const ChildEnd&) {}

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
  const auto died = [&](const ChildEnd& end) { throw InputError(how = end.signal()); };
  const auto raised = [](const std::string& signal) -> std::string {
    std::raise(std::stoi(signal));
    return "";
  };
  for (const int signal : {SIGSEGV, SIGTERM, SIGKILL})
    TEST_THROW(in_child_process(raised, std::to_string(signal), died), InputError);
  TEST_EQUALITY(how, "Killed");
  const auto exits = [](auto&) -> std::string { _exit(3); };
  TEST_THROW(in_child_process(exits, "", nothing), ResourceError);
  ChildEnd seen;
  TEST_THROW(in_child_process(exits, "", [&](const ChildEnd& end) { seen = end; }), ResourceError);
  TEST_ASSERT(seen.by == ChildEnd::By::itself);
  TEST_EQUALITY(seen.number, 3);
  TEST_EQUALITY(in_child_process(echo, "goes on", nothing), "goes on");
}

// A child that wants more than the machine has free is refused it, whatever it does then, and its program goes on.
TEUCHOS_UNIT_TEST(ChildProcess, GetsHalfOfTheMemoryThatIsFree) {
  ChildEnd seen;
  const auto died = [&](const ChildEnd& end) {
    seen = end;
    throw InputError("too much");
  };
  // Asked for at once, and never touched: the machine is not to suffer.
  const auto wants_all = [](auto&) -> std::string {
    ::operator delete(::operator new(static_cast<std::size_t>(free_memory())));
    return "got it";
  };
  TEST_THROW(in_child_process(wants_all, "", died), InputError);
  TEST_ASSERT(seen.by == ChildEnd::By::memory);
  TEST_COMPARE(seen.allowed, <, 0.6 * whole_memory());
  const auto wants_little = [](auto&) { return std::string(1'000'000, 'v'); };
  TEST_EQUALITY(in_child_process(wants_little, "", died).size(), 1'000'000u);
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

// Killed, which no process can hear of: the process that waits and its child end with the program.
TEUCHOS_UNIT_TEST(ChildProcess, AKilledProgramLeavesNobodyAtWork) {
  const std::string file = "processes-of-a-killed-program";
  std::remove(file.c_str());
  const auto work = [](const std::string& where) -> std::string {
    begin_child_processes();
    return in_child_process(
        [](const std::string& name) -> std::string {
          const pid_t waiting = getppid();
          std::ofstream(name + ".part") << waiting << ' ' << getpid();
          std::rename((name + ".part").c_str(), name.c_str());
          for (;;) pause();
        },
        where, nothing);
  };
  const auto killer = [&] {  // the child that is the program here is the parent of the process that waits
    std::string waiting, child;
    for (int tenths = 0; tenths < 300 && !(std::ifstream(file) >> waiting >> child); ++tenths) usleep(100'000);
    std::ifstream status("/proc/" + waiting + "/status");
    for (std::string word; status >> word;)
      if (pid_t program = 0; word == "PPid:" && status >> program) ::kill(program, SIGKILL);
    return std::make_pair(waiting, child);
  };
  std::pair<std::string, std::string> left;
  std::thread other([&] { left = killer(); });
  TEST_THROW(in_child_process(work, file, [](const ChildEnd& end) { throw InputError(end.signal()); }), InputError);
  other.join();
  TEST_ASSERT(!left.second.empty());
  for (const auto& process : {left.first, left.second}) {
    for (int tenths = 0; tenths < 100 && lives(process); ++tenths) usleep(100'000);
    TEST_ASSERT(!lives(process));
  }
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
