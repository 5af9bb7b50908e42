// A program of pieces of work that end well, throw, crash or want too much: what test_base asks for.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <new>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/free_memory.hpp"

namespace {

using namespace voussoir;

std::string echo(const std::string& request) { return request; }

int begun = 0;
std::string count(const std::string&) { return std::to_string(++begun); }

/// Numbers of files that are open here, but for the connections of this process and its parent's, which are 0 to 4.
std::string open_files(const std::string&) {
  std::string open;
  for (int file = 5; file < 1024; ++file)
    if (::lseek(file, 0, SEEK_CUR) >= 0) open += std::to_string(file) + " ";
  return open;
}

std::string parent(const std::string&) { return std::to_string(::getppid()); }

std::string wrong_input(const std::string& what) { throw InputError(what); }
std::string no_resource(const std::string& what) { throw ResourceError(what); }
std::string odd(const std::string& what) { throw std::runtime_error(what); }

std::string raise_signal(const std::string& signal) {
  std::raise(std::stoi(signal));
  return "";
}

std::string leave(const std::string&) { ::_exit(3); }

/// Asked for at once, and never touched: the machine is not to suffer.
std::string want_all(const std::string&) {
  ::operator delete(::operator new(static_cast<std::size_t>(free_memory())));
  return "got it";
}

std::string want_little(const std::string&) { return std::string(1'000'000, 'v'); }

/// This process is a program that asks another, and ends: it tells which process waited for it.
std::string ask_and_end(const std::string&) {
  return in_child_process("planted-works", "parent", "", [](const ChildEnd&) {});
}

/// Writes the process that waits and itself into a file and works for ever.
std::string work_on(const std::string& name) {
  std::ofstream(name + ".part") << ::getppid() << ' ' << ::getpid();
  std::rename((name + ".part").c_str(), name.c_str());
  for (;;) ::pause();
}

std::string ask_and_wait(const std::string& file) {
  return in_child_process("planted-works", "work on", file, [](const ChildEnd&) {});
}

}  // namespace

int main(int argc, char** argv) {
  return serve_works(argc, argv,
                     {{"echo", echo},
                      {"count", count},
                      {"open files", open_files},
                      {"parent", parent},
                      {"wrong input", wrong_input},
                      {"no resource", no_resource},
                      {"odd", odd},
                      {"raise", raise_signal},
                      {"leave", leave},
                      {"want all", want_all},
                      {"want little", want_little},
                      {"ask and end", ask_and_end},
                      {"work on", work_on},
                      {"ask and wait", ask_and_wait}});
}
