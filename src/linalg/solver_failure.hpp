// What happens where a library cannot solve a system: whoever knows another way takes it, a step without one fails.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "linalg/agree.hpp"

namespace voussoir {

/// A library did not factor or solve a system. The message names the library and its status.
class SolverFailure : public ConvergenceError {
 public:
  using ConvergenceError::ConvergenceError;
};

/// @param status  as the manual of the library counts
inline SolverFailure solver_failure(const std::string& library, const std::string& what, int status) {
  return SolverFailure(library + " could not " + what + " (its status: " + std::to_string(status) + ")");
}

/// Does work in which systems of single ranks are factored or solved. Where that fails on one rank it fails on all: the
/// others say what the first of those that failed would, so that nobody waits. Work may be collective as long as its
/// last collective call comes before what fails. Collective.
template <class Work>
void all_or_none(const Teuchos::Comm<int>& comm, const Work& work) {
  std::optional<std::string> failure;
  try {
    work();
  } catch (const SolverFailure& mine) {
    failure = mine.what();
  }
  if (const auto first = first_text(comm, failure)) throw SolverFailure(*first);
}

/// Does a solve of this rank alone inside an iteration of all ranks. Where that fails the solution is not a number: an
/// error would take this rank away from the next collective call, where the others wait, while the next norm that is
/// not a number ends the iteration on all of them (LinearSolver::solve).
template <class Solve>
void solve_or_not_a_number(std::vector<double>& solution, const Solve& solve) {
  try {
    solve();
  } catch (const SolverFailure&) {
    std::fill(solution.begin(), solution.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace voussoir
