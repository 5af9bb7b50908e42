// Seconds of the processor, which other programs on the machine disturb less than those of the clock.
#pragma once

#include <chrono>
#include <ctime>

#include "linalg/reduce.hpp"
#include "linalg/seconds_in_mpi.hpp"

namespace voussoir {

/// Seconds of the processor since it was made, slowest rank.
class ProcessorClock {
 public:
  explicit ProcessorClock(const Teuchos::Comm<int>& comm) : comm_(comm), start_(std::clock()) {}
  /// Collective.
  double seconds() const {
    return largest_over_ranks(comm_, static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC);
  }

 private:
  const Teuchos::Comm<int>& comm_;
  std::clock_t start_;
};

/// What a piece of work took.
struct SecondsOfRanks {
  double clock = 0;      ///< on the wall, slowest rank
  double processor = 0;  ///< likewise, with what ranks wait for each other
  double work = 0;       ///< of the processor outside MPI, the rank with most
  double mean_work = 0;  ///< of all ranks
};

/// Since it was made, which all ranks do together. What is outside MPI depends neither on the network nor on how many
/// ranks share a core.
class ClockOfRanks {
 public:
  explicit ClockOfRanks(const Teuchos::Comm<int>& comm)
      : comm_(comm), processor_(comm), start_(std::clock()), in_mpi_(seconds_in_mpi()) {
    comm.barrier();
    began_ = std::chrono::steady_clock::now();
  }
  /// Collective.
  SecondsOfRanks seconds() const {
    const double clock = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    const double work = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC - (seconds_in_mpi() - in_mpi_);
    return {largest_over_ranks(comm_, clock), processor_.seconds(), largest_over_ranks(comm_, work),
            total_over_ranks(comm_, work) / comm_.getSize()};
  }

 private:
  const Teuchos::Comm<int>& comm_;
  ProcessorClock processor_;
  std::clock_t start_;
  double in_mpi_;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace voussoir
