// Seconds of the processor, which other programs on the machine disturb less than those of the clock.
#pragma once

#include <ctime>

#include "linalg/reduce.hpp"

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

}  // namespace voussoir
