#include "base/child_process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/error.hpp"

namespace voussoir {
namespace {

enum Outcome : char { bytes = 'b', input = 'i', resource = 'r' };

/// All of the text, however small the pipe; false when nobody reads.
bool write_all(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(to, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return true;
}

std::string read_all(int from) {
  std::string text;
  char part[1 << 16];
  for (;;) {
    const ssize_t count = ::read(from, part, sizeof part);
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

std::string outcome_of(const std::function<std::string()>& work) {
  try {
    return char(bytes) + work();
  } catch (const InputError& error) {
    return char(input) + std::string(error.what());
  } catch (const std::exception& error) {
    return char(resource) + message_of(error);
  }
}

}  // namespace

std::string in_child_process(const std::function<std::string()>& work,
                             const std::function<void(const std::string& signal)>& died) {
  int ends[2];
  const bool piped = ::pipe(ends) == 0;
  const pid_t child = piped ? ::fork() : -1;
  if (child < 0)
    throw ResourceError("no process can be begun\n  because of: " + std::string(std::strerror(errno)) +
                        ".\n  Free memory or end other processes.");
  if (child == 0) {
    ::close(ends[0]);
    // Not the handlers of this process: MPI would print pages, a run would note the signal and go on.
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT}) std::signal(signal, SIG_DFL);
    ::_exit(write_all(ends[1], outcome_of(work)) ? 0 : 1);
  }
  ::close(ends[1]);
  const std::string said = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) died(strsignal(WTERMSIG(status)));
  if (said.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw ResourceError("a process of this program ended without a result.\n  Free memory and begin again.");
  const std::string what = said.substr(1);
  if (said[0] == input) throw InputError(what);
  if (said[0] == resource) throw ResourceError(what);
  return what;
}

}  // namespace voussoir
