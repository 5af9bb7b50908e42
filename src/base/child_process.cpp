#include "base/child_process.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "base/error.hpp"
#include "base/free_memory.hpp"

namespace voussoir {
namespace {

enum Outcome : char { bytes = 'b', input = 'i', resource = 'r', memory = 'm' };

// A child may take half of what is free: what is made of its answer takes more than the child did, so with less left
// the answer would be of no use. A third of that for the answer, of which child, waiting process and program have a
// copy each.
constexpr double share_of_free = 0.5, share_of_answer = 1.0 / 3;
// What a small drawing takes, libraries included [bytes]; where less is free the kernel decides.
constexpr double least_allowed = 3e8;
// A child that dies with so much of what it is allowed has died for want of more: libraries do not always say so.
constexpr double nearly_all = 0.7;
// A child is told within that of a stop, which nobody notices [ms].
constexpr int between_looks = 200;

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
  ChildEnd end;
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

bool (*asked_to_stop)() = nullptr;

/// Ends with its parent, however that ends. A parent that has ended meanwhile is the parent no more.
void end_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
}

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

/// All bytes until the other end closes, or one more than are allowed.
std::string receive_rest(int from, double most) {
  std::string text;
  char part[1 << 16];
  for (;;) {
    const ssize_t count = ::recv(from, part, sizeof part, 0);
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR) || static_cast<double>(text.size()) > most) return text;
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
    return char(is_out_of_memory(error) ? memory : resource) + message_of(error);
  }
}

std::string answer_of(const std::string& outcome) {
  const std::string what = outcome.substr(1);
  if (outcome[0] == input) throw InputError(what);
  if (outcome[0] == resource) throw ResourceError(what);
  return what;
}

/// In a child: no more memory than that beside what it was born with [bytes].
void allow_memory(double more) {
  const double most = data_of_this_process() + more;
  const rlimit limit{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  ::setrlimit(RLIMIT_DATA, &limit);
}

[[noreturn]] void live_as_child(ChildWork work, const std::string& request, int end, pid_t parent, double allowed) {
  end_with(parent);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_DFL);
  allow_memory(allowed);
  const std::string done = outcome_of(work, request);
  ::_exit(send_all(end, done.data(), done.size()) ? 0 : 1);
}

/// How a child ended: by status and use as wait4() gives them.
ChildEnd end_of(int status, const rusage& use, double seconds, double allowed) {
  ChildEnd end;
  end.by = WIFSIGNALED(status) ? ChildEnd::By::signal : ChildEnd::By::itself;
  end.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  end.seconds = seconds;
  end.peak = 1024.0 * static_cast<double>(use.ru_maxrss);
  end.allowed = allowed;
  return end;
}

/// In the process that waits: one child, to its end.
Reply run_child(ChildWork work, const std::string& request, std::string& outcome) {
  const auto begin = std::chrono::steady_clock::now();
  const double allowed = std::max(share_of_free * free_memory(), least_allowed);
  const pid_t here = ::getpid();
  int ends[2];
  const pid_t child = connect(ends) ? ::fork() : -1;
  if (child < 0) return {-1, errno, 0, {}};
  if (child == 0) {
    ::close(ends[0]);
    live_as_child(work, request, ends[1], here, allowed);
  }
  ::close(ends[1]);
  outcome = receive_rest(ends[0], share_of_answer * allowed);
  ::close(ends[0]);
  const bool too_long = static_cast<double>(outcome.size()) > share_of_answer * allowed;
  if (too_long) ::kill(child, SIGKILL);
  int status = 0;
  rusage use{};
  while (::wait4(child, &status, 0, &use) < 0 && errno == EINTR) {
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  auto end = end_of(status, use, time.count(), allowed);
  const bool failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0 || outcome.empty();
  if (too_long || (!outcome.empty() && outcome[0] == memory) || (failed && end.peak > nearly_all * allowed))
    end.by = ChildEnd::By::memory;
  if (too_long) outcome.clear();
  return {status, 0, outcome.size(), end};
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
  const pid_t program = ::getpid(), copy = ::fork();
  if (copy == 0) {
    end_with(program);
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

void end_child_processes_when(bool (*asked)()) { asked_to_stop = asked; }

std::string ChildEnd::signal() const { return strsignal(number); }

std::string ChildEnd::time_and_size() const {
  char text[64];
  std::snprintf(text, sizeof text, "after %.3g s, with %.2g GB", seconds, peak / 1e9);
  return text;
}

namespace {

/// Waits for a reply. False when the program is asked to stop meanwhile.
bool reply_comes() {
  pollfd end{waiting.end, POLLIN, 0};
  for (;;) {
    if (asked_to_stop && asked_to_stop()) return false;
    const int found = ::poll(&end, 1, between_looks);
    if (found > 0 || (found < 0 && errno != EINTR)) return true;
  }
}

/// The process that waits and its child end; there are no child processes after that.
void end_all() {
  ::kill(waiting.process, SIGKILL);
  ::waitpid(waiting.process, nullptr, 0);
  ::close(waiting.end);
  waiting.end = -1;
}

}  // namespace

std::string in_child_process(ChildWork work, const std::string& request,
                             const std::function<void(const ChildEnd&)>& died) {
  if (waiting.end < 0) return answer_of(outcome_of(work, request));
  const Request head{work, request.size()};
  Reply reply{};
  std::string outcome;
  bool answered = send_all(waiting.end, &head, sizeof head) && send_all(waiting.end, request.data(), request.size());
  if (answered && !reply_comes()) {
    end_all();
    reply.end.by = ChildEnd::By::request;
    died(reply.end);
    throw ResourceError("a process of this program was asked to stop.\n  Begin again.");
  }
  answered = answered && receive_all(waiting.end, &reply, sizeof reply);
  if (answered) {
    outcome.resize(reply.size);
    answered = receive_all(waiting.end, outcome.data(), outcome.size());
  }
  if (answered && reply.status < 0)
    throw ResourceError("no process can be begun\n  because of: " + std::string(std::strerror(reply.error)) +
                        ".\n  Free memory or end other processes.");
  const bool ended_well = answered && WIFEXITED(reply.status) && WEXITSTATUS(reply.status) == 0 && !outcome.empty();
  if (answered && (!ended_well || reply.end.by == ChildEnd::By::memory)) died(reply.end);
  if (!ended_well)
    throw ResourceError("a process of this program ended without a result.\n  Free memory and begin again.");
  return answer_of(outcome);
}

}  // namespace voussoir
