#include "run/stop_signals.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>

#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

volatile std::sig_atomic_t received = 0;

void remember(int) { received = 1; }

const auto start = std::chrono::steady_clock::now();
double time_allowed = std::numeric_limits<double>::infinity();  // [s] since the start

/// Between two questions, the longest so far: a linear solve, as a rule.
struct Pace {
  double asked = -1, longest = 0;  ///< [s]
};
Pace pace;

bool over_by_the_next_question() {
  const double now = seconds_since_start();
  if (pace.asked >= 0) pace.longest = std::max(pace.longest, now - pace.asked);
  pace.asked = now;
  return now + pace.longest > time_allowed;
}

/// @param keeps  what ignores the signal goes on to, as a program in the background of a shell does
void take(int signal, int flags, bool keeps) {
  struct sigaction action {
  }, before{};
  sigaction(signal, nullptr, &before);
  if (keeps && before.sa_handler == SIG_IGN) return;
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART | flags;  // MPI does not expect its system calls to be interrupted
  sigaction(signal, &action, nullptr);
}

}  // namespace

void listen_for_stop_signals() {
  const auto once = static_cast<int>(SA_RESETHAND);
  take(SIGUSR1, 0, false);
  take(SIGTERM, once, false);
  take(SIGINT, once, true);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_within(double seconds) { time_allowed = std::min(time_allowed, seconds); }

double seconds_since_start() { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }

bool stop_wanted_here() { return received != 0 || seconds_since_start() > time_allowed; }

Stop stop_wanted(const Teuchos::Comm<int>& comm) {
  auto mine = comm.getRank() == 0 && over_by_the_next_question() ? Stop::time_is_over : Stop::no;
  if (received != 0) mine = Stop::signal;
  return static_cast<Stop>(largest_over_ranks(comm, static_cast<int>(mine)));
}

}  // namespace voussoir
