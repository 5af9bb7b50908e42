// Work in a process of its own: what it returns, what it throws, and how it dies.
#include "base/child_process.hpp"

#include <fcntl.h>
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

/// By the program of planted_works.cpp, which lies beside this one.
std::string asked(const std::string& work, const std::string& request,
                  const std::function<void(const ChildEnd&)>& died = nothing) {
  return in_child_process("planted-works", work, request, died);
}

TEUCHOS_UNIT_TEST(ChildProcess, ReturnsBytesOfAnyNumber) {
  const std::string long_text(3'000'001, 'v');  // many times what a socket holds
  TEST_ASSERT(asked("echo", long_text) == long_text);
  TEST_EQUALITY(asked("echo", std::string("a\0b", 3)), std::string("a\0b", 3));
  TEST_EQUALITY(asked("echo", ""), "");
}

// Each piece of work begins with the process as it was loaded, whatever was done before it.
TEUCHOS_UNIT_TEST(ChildProcess, IsACopyOfAProcessThatHasDoneNothing) {
  for (int k = 0; k < 2; ++k) TEST_EQUALITY(asked("count", ""), "1");
}

// Files of this program, such as results that are being written, are not held open by others.
TEUCHOS_UNIT_TEST(ChildProcess, HasNoFilesOfThisProgram) {
  const int here = ::open("a-file-of-this-program", O_CREAT | O_RDWR, 0600);
  ::kill(std::stoi(asked("parent", "")), SIGKILL);  // the next one is begun with the file open
  TEST_THROW(asked("echo", ""), ResourceError);
  TEST_EQUALITY(asked("open files", ""), "");
  ::close(here);
}

TEUCHOS_UNIT_TEST(ChildProcess, ThrowsHereWhatIsThrownThere) {
  const auto message = [](const std::string& program, const std::string& work, const std::string& what) -> std::string {
    try {
      in_child_process(program, work, what, nothing);
    } catch (const InputError& error) {
      return std::string("input: ") + error.what();
    } catch (const ResourceError& error) {
      return std::string("resource: ") + error.what();
    }
    return "";
  };
  const std::string planted = "planted-works";
  TEST_EQUALITY(message(planted, "wrong input", "a.msh is empty"), "input: a.msh is empty");
  TEST_EQUALITY(message(planted, "no resource", "disk full"), "resource: disk full");
  TEST_EQUALITY(message(planted, "odd", "odd"), "resource: odd");
  TEST_EQUALITY(message(planted, "dance", ""), "resource: \"dance\" is no work of this program");
  const std::string none = message("no-such-program", "echo", "");
  TEST_ASSERT(none.find("resource: the program no-such-program is not found") == 0);
  TEST_ASSERT(none.find("on PATH") != std::string::npos);
}

TEUCHOS_UNIT_TEST(ChildProcess, TellsOfItsDeathAndTheNextOneWorks) {
  std::string how;
  const auto died = [&](const ChildEnd& end) { throw InputError(how = end.signal()); };
  for (const int signal : {SIGSEGV, SIGTERM, SIGKILL})
    TEST_THROW(asked("raise", std::to_string(signal), died), InputError);
  TEST_EQUALITY(how, "Killed");
  TEST_THROW(asked("leave", ""), ResourceError);
  ChildEnd seen;
  TEST_THROW(asked("leave", "", [&](const ChildEnd& end) { seen = end; }), ResourceError);
  TEST_ASSERT(seen.by == ChildEnd::By::itself);
  TEST_EQUALITY(seen.number, 3);
  TEST_EQUALITY(asked("echo", "goes on"), "goes on");
}

// Somebody, or the kernel for want of memory, may kill the process that waits: that is said, and another is begun.
TEUCHOS_UNIT_TEST(ChildProcess, AKilledProcessThatWaitsIsFollowedByAnother) {
  const std::string waits = asked("parent", "");
  ::kill(std::stoi(waits), SIGKILL);
  TEST_THROW(asked("echo", "lost"), ResourceError);
  TEST_EQUALITY(asked("echo", "goes on"), "goes on");
  TEST_INEQUALITY(asked("parent", ""), waits);
}

// A child that wants more than the machine has free is refused it, whatever it does then, and its program goes on.
TEUCHOS_UNIT_TEST(ChildProcess, GetsHalfOfTheMemoryThatIsFree) {
  ChildEnd seen;
  const auto died = [&](const ChildEnd& end) {
    seen = end;
    throw InputError("too much");
  };
  TEST_THROW(asked("want all", "", died), InputError);
  TEST_ASSERT(seen.by == ChildEnd::By::memory);
  TEST_COMPARE(seen.allowed, <, 0.6 * whole_memory());
  TEST_EQUALITY(asked("want little", "", died).size(), 1'000'000u);
}

/// Whether a process is there and is more than an entry in a table.
bool lives(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string number_of, name, state;
  return file >> number_of >> name >> state && state != "Z";
}

// The process that waits ends with its program: here a child is the program, and its end is that of a killed one.
TEUCHOS_UNIT_TEST(ChildProcess, NobodyIsLeftBehind) {
  const std::string waiting = asked("ask and end", "");
  TEST_INEQUALITY(waiting, std::to_string(getpid()));
  for (int tenths = 0; tenths < 100 && lives(waiting); ++tenths) usleep(100'000);
  TEST_ASSERT(!lives(waiting));
}

// Killed, which no process can hear of: the process that waits and its child end with the program.
TEUCHOS_UNIT_TEST(ChildProcess, AKilledProgramLeavesNobodyAtWork) {
  const std::string file = "processes-of-a-killed-program";
  std::remove(file.c_str());
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
  TEST_THROW(asked("ask and wait", file, [](const ChildEnd& end) { throw InputError(end.signal()); }), InputError);
  other.join();
  TEST_ASSERT(!left.second.empty());
  for (const auto& process : {left.first, left.second}) {
    for (int tenths = 0; tenths < 100 && lives(process); ++tenths) usleep(100'000);
    TEST_ASSERT(!lives(process));
  }
}

}  // namespace
}  // namespace voussoir
