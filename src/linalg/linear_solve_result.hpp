// What became of the solution of a linear system.
#pragma once

#include <string>
#include <utility>

namespace voussoir {

struct LinearSolveResult {
  int iterations = 0;      ///< of the Krylov method
  bool converged = false;  ///< to the accuracy asked for; where not, the unknowns hold what was reached
  std::string failure;     ///< where not: which library stopped, and what it says
  bool nothing = false;    ///< a library refused the system: the unknowns are as they were
};

/// Of a system that a library refused.
inline LinearSolveResult not_solved(std::string failure) { return {0, false, std::move(failure), true}; }

}  // namespace voussoir
