#include "base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
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
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <map>
#include <sstream>
#include <vector>

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

// Where a program that works finds the connection to the one that asks.
constexpr int connection = 3;

/// What precedes the name of the work and the bytes of a request.
struct Request {
  std::size_t name, size;
};
/// What precedes the bytes of a reply.
struct Reply {
  int status;  ///< of the child, as waitpid() gives it; -1 where none could be begun, for the reason in `error`
  int error;
  std::size_t size;
  ChildEnd end;
};

/// A process that waits and our end of the connection to it; -1 where there is none.
struct Waiting {
  int end = -1;
  pid_t process = -1;
  Waiting() = default;
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  /// A program that ends by itself sees it off; one that is killed closes the connection, which ends it too.
  ~Waiting() {
    if (end < 0) return;
    ::shutdown(end, SHUT_RDWR);
    ::close(end);
    ::waitpid(process, nullptr, 0);
  }
};
/// By the names of programs.
std::map<std::string, Waiting> waiting;

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
void serve(int end, const std::map<std::string, ChildWork>& works) {
  // Signals that ask the program to stop reach this process too; the program decides when it ends.
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_IGN);
  Request head;
  while (receive_all(end, &head, sizeof head)) {
    std::string name(head.name, '\0'), request(head.size, '\0'), outcome;
    if (!receive_all(end, name.data(), name.size()) || !receive_all(end, request.data(), request.size())) return;
    const auto work = works.find(name);
    Reply reply{0, 0, 0, {}};
    if (work != works.end())
      reply = run_child(work->second, request, outcome);
    else
      outcome = char(resource) + ("\"" + name + "\" is no work of this program"), reply.size = outcome.size();
    if (!send_all(end, &reply, sizeof reply) || !send_all(end, outcome.data(), outcome.size())) return;
  }
}

/// The folder of the program that runs.
std::string own_folder() {
  char path[4096];
  const ssize_t size = ::readlink("/proc/self/exe", path, sizeof path);
  const std::string whole(path, size > 0 ? static_cast<std::size_t>(size) : 0);
  return whole.substr(0, whole.rfind('/') + 1);
}

/// Folders in which programs of this project are looked for: that of the one that runs, those where it is built and
/// installed, those of the user.
std::vector<std::string> folders_of_programs() {
  std::vector<std::string> folders{own_folder()};
  const char* path = std::getenv("PATH");
  std::istringstream list(std::string(VOUSSOIR_PROGRAM_FOLDERS ":") + (path ? path : ""));
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.push_back(folder + "/");
  return folders;
}

std::string path_of(const std::string& program) {
  const auto folders = folders_of_programs();
  for (const auto& folder : folders)
    if (::access((folder + program).c_str(), X_OK) == 0) return folder + program;
  throw ResourceError("the program " + program + " is not found, neither in " + folders.front() +
                      " beside this one nor on PATH.\n  Put it there; it is built and installed with voussoir.");
}

[[noreturn]] void refuse_to_begin(int error) {
  throw ResourceError("no process can be begun\n  because of: " + std::string(std::strerror(error)) +
                      ".\n  Free memory or end other processes.");
}

/// Begins the process that waits. It has one connection and none of the other files that are open here.
void begin(Waiting& process, const std::string& program) {
  const std::string path = path_of(program), here = std::to_string(::getpid());
  int ends[2];
  int error = connect(ends) ? 0 : errno;
  if (error == 0) {
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], connection);
    ::posix_spawn_file_actions_addclosefrom_np(&files, connection + 1);
    std::string name = program, parent = here;
    char* words[] = {name.data(), parent.data(), nullptr};
    error = ::posix_spawn(&process.process, path.c_str(), &files, nullptr, words, environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    if (error != 0) ::close(ends[0]);
  }
  if (error != 0) refuse_to_begin(error);
  process.end = ends[0];
}

}  // namespace

int serve_works(int argc, char** argv, const std::map<std::string, ChildWork>& works) {
  const int parent = argc == 2 ? std::atoi(argv[1]) : 0;
  if (parent <= 0 || ::fcntl(connection, F_GETFD) < 0) {
    std::fprintf(stderr, "%s is begun by other programs, which ask it for work.\n", argv[0]);
    return 2;
  }
  ::fcntl(connection, F_SETFD, FD_CLOEXEC);
  end_with(parent);
  serve(connection, works);
  ::_exit(0);
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
bool reply_comes(int from) {
  pollfd end{from, POLLIN, 0};
  for (;;) {
    if (asked_to_stop && asked_to_stop()) return false;
    const int found = ::poll(&end, 1, between_looks);
    if (found > 0 || (found < 0 && errno != EINTR)) return true;
  }
}

bool has_succeeded(int status) { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }

[[noreturn]] void refuse_to_wait(const std::function<void(const ChildEnd&)>& died) {
  ChildEnd end;
  end.by = ChildEnd::By::request;
  died(end);
  throw ResourceError("a process of this program was asked to stop.\n  Begin again.");
}

bool send_request(int to, const std::string& work, const std::string& request) {
  const Request head{work.size(), request.size()};
  return send_all(to, &head, sizeof head) && send_all(to, work.data(), work.size()) &&
         send_all(to, request.data(), request.size());
}

bool receive_reply(int from, Reply& reply, std::string& outcome) {
  if (!receive_all(from, &reply, sizeof reply)) return false;
  outcome.resize(reply.size);
  return receive_all(from, outcome.data(), outcome.size());
}

}  // namespace

std::string in_child_process(const std::string& program, const std::string& work, const std::string& request,
                             const std::function<void(const ChildEnd&)>& died) {
  Waiting& process = waiting[program];
  if (process.end < 0) begin(process, program);
  Reply reply{};
  std::string outcome;
  bool answered = send_request(process.end, work, request);
  const bool stopped = answered && !reply_comes(process.end);
  answered = answered && !stopped && receive_reply(process.end, reply, outcome);
  if (stopped) ::kill(process.process, SIGKILL);  // its child ends with it
  if (!answered) waiting.erase(program);          // the next one who asks begins another
  if (stopped) refuse_to_wait(died);
  if (answered && reply.status < 0) refuse_to_begin(reply.error);
  const bool ended_well = answered && has_succeeded(reply.status) && !outcome.empty();
  if (answered && (!ended_well || reply.end.by == ChildEnd::By::memory)) died(reply.end);
  if (!ended_well)
    throw ResourceError("a process of this program ended without a result.\n  Free memory and begin again.");
  return answer_of(outcome);
}

}  // namespace voussoir
