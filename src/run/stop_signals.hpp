// Why a run is to stop before its end: signals, as batch systems and keyboards send them, and a time that is over.
#pragma once

#include <Teuchos_Comm.hpp>

namespace voussoir {

/// From now on SIGTERM, SIGUSR1 and SIGINT are remembered instead of ending the program; the second SIGTERM or SIGINT
/// ends it. A file that outgrows its limit becomes an error of writing, like a full disk, instead of a signal that ends
/// the program.
void listen_for_stop_signals();

/// The run is to stop before so many seconds have passed since the program began. The clock of the first rank decides;
/// to be called on all. The smaller one holds where it is called twice.
void stop_within(double seconds);

/// [s] since the program began.
double seconds_since_start();

/// Whether a signal has reached this rank, or its time is over.
bool stop_wanted_here();

enum class Stop { no, time_is_over, signal };

/// Whether the run is to stop; of two reasons the signal. The time counts as over when it would be by the next
/// question, as far as those so far tell. Collective; the same answer on all ranks.
Stop stop_wanted(const Teuchos::Comm<int>&);

}  // namespace voussoir
