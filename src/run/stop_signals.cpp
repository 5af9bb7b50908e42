#include "run/stop_signals.hpp"

#include <csignal>

#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

volatile std::sig_atomic_t received = 0;

void remember(int) { received = 1; }

}  // namespace

void listen_for_stop_signals() {
  struct sigaction action {};
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;  // MPI does not expect its system calls to be interrupted
  sigaction(SIGUSR1, &action, nullptr);
  action.sa_flags |= static_cast<int>(SA_RESETHAND);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_signal_here() { return received != 0; }

bool stop_signal_on_any_rank(const Teuchos::Comm<int>& comm) { return any_of_ranks(comm, stop_signal_here()); }

}  // namespace voussoir
