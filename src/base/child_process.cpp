#include "base/child_process.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <initializer_list>

#include "base/error.hpp"

namespace voussoir {
namespace {

enum Outcome : char { bytes = 'b', input = 'i', resource = 'r' };

/// What precedes the bytes of a request. The process that waits is a copy of this one, so a function is where it is.
struct Request {
  ChildWork work;
  std::size_t size;
};
/// What precedes the bytes of a reply.
struct Reply {
  int status;  ///< of the child, as waitpid() gives it; -1 where none could be begun, for the reason in `error`
  int error;
  std::size_t size;
};

/// The process that waits and our end of the connection to it; -1 where there is none.
struct Waiting {
  int end = -1;
  pid_t process = -1;
  /// A program that ends by itself sees it off; one that is killed closes the connection, which ends it too.
  ~Waiting() {
    if (end < 0) return;
    ::shutdown(end, SHUT_RDWR);
    ::waitpid(process, nullptr, 0);
  }
} waiting;

/// All of the bytes, however few fit at once; false when nobody reads.
bool send_all(int to, const void* from, std::size_t size) {
  const char* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t count = ::send(to, at, size, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) at += count, size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// As many bytes as are wanted; false when fewer come.
bool receive_all(int from, void* to, std::size_t size) {
  char* at = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t count = ::recv(from, at, size, 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count > 0) at += count, size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// All bytes until the other end closes.
std::string receive_rest(int from) {
  std::string text;
  char part[1 << 16];
  for (;;) {
    const ssize_t count = ::recv(from, part, sizeof part, 0);
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

/// Two connected ends, which close in programs that are begun from here (mpirun's helpers); false without any.
bool connect(int (&ends)[2]) { return ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0; }

std::string outcome_of(ChildWork work, const std::string& request) {
  try {
    return char(bytes) + work(request);
  } catch (const InputError& error) {
    return char(input) + std::string(error.what());
  } catch (const std::exception& error) {
    return char(resource) + message_of(error);
  }
}

std::string answer_of(const std::string& outcome) {
  const std::string what = outcome.substr(1);
  if (outcome[0] == input) throw InputError(what);
  if (outcome[0] == resource) throw ResourceError(what);
  return what;
}

/// In the process that waits: one child, to its end.
Reply run_child(ChildWork work, const std::string& request, std::string& outcome) {
  int ends[2];
  const pid_t child = connect(ends) ? ::fork() : -1;
  if (child < 0) return {-1, errno, 0};
  if (child == 0) {
    ::close(ends[0]);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_DFL);
    const std::string done = outcome_of(work, request);
    ::_exit(send_all(ends[1], done.data(), done.size()) ? 0 : 1);
  }
  ::close(ends[1]);
  outcome = receive_rest(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {status, 0, outcome.size()};
}

/// The life of the process that waits: requests, until the other end closes.
void serve(int end) {
  // Signals that ask the program to stop reach this process too; the program decides when it ends.
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_IGN);
  Request head;
  while (receive_all(end, &head, sizeof head)) {
    std::string request(head.size, '\0'), outcome;
    if (!receive_all(end, request.data(), request.size())) return;
    const Reply reply = run_child(head.work, request, outcome);
    if (!send_all(end, &reply, sizeof reply) || !send_all(end, outcome.data(), outcome.size())) return;
  }
}

}  // namespace

void begin_child_processes() {
  int ends[2];
  if (waiting.end >= 0 || !connect(ends)) return;
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::close(ends[0]);
    serve(ends[1]);
    ::_exit(0);
  }
  ::close(ends[1]);
  if (copy < 0)
    ::close(ends[0]);
  else
    waiting.end = ends[0], waiting.process = copy;
}

std::string in_child_process(ChildWork work, const std::string& request,
                             const std::function<void(const std::string& signal)>& died) {
  if (waiting.end < 0) return answer_of(outcome_of(work, request));
  const Request head{work, request.size()};
  Reply reply{};
  std::string outcome;
  bool answered = send_all(waiting.end, &head, sizeof head) && send_all(waiting.end, request.data(), request.size()) &&
                  receive_all(waiting.end, &reply, sizeof reply);
  if (answered) {
    outcome.resize(reply.size);
    answered = receive_all(waiting.end, outcome.data(), outcome.size());
  }
  if (answered && reply.status < 0)
    throw ResourceError("no process can be begun\n  because of: " + std::string(std::strerror(reply.error)) +
                        ".\n  Free memory or end other processes.");
  if (answered && WIFSIGNALED(reply.status)) died(strsignal(WTERMSIG(reply.status)));
  if (outcome.empty() || !answered || !WIFEXITED(reply.status) || WEXITSTATUS(reply.status) != 0)
    throw ResourceError("a process of this program ended without a result.\n  Free memory and begin again.");
  return answer_of(outcome);
}

}  // namespace voussoir
