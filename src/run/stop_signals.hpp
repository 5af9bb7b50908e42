// SIGTERM and SIGUSR1: what batch systems send before they kill a run.
#pragma once

#include <Teuchos_Comm.hpp>

namespace voussoir {

/// From now on both signals are remembered instead of ending the program; the second SIGTERM ends it. A file that
/// outgrows its limit becomes an error of writing, like a full disk, instead of a signal that ends the program.
void listen_for_stop_signals();

/// Whether a signal has reached this rank.
bool stop_signal_here();
/// Whether a signal has reached any rank. Collective; the same answer on all ranks.
bool stop_signal_on_any_rank(const Teuchos::Comm<int>&);

}  // namespace voussoir
