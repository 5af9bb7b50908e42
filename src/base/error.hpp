// What can go wrong, by who has to act; the main program turns it into an exit code.
#pragma once

#include <new>
#include <stdexcept>
#include <string>

namespace voussoir {

/// The input is wrong: the message names the key or block, the value, why, and what to do. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The solution was not found; the state before the failed step is saved. Exit code 3.
class ConvergenceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something outside the scene is missing: a file that cannot be written, memory, a library. Exit code 4.
class ResourceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether memory is short: most libraries throw std::bad_alloc, Kokkos a runtime_error of its own.
inline bool is_out_of_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) ||
         std::string(error.what()).find("failed to allocate memory") != std::string::npos;
}
inline constexpr auto out_of_memory_message =
    "voussoir: not enough memory.\n  Use more ranks on more machines, or larger cells.";

/// What to tell a user of an exception of any kind.
inline std::string message_of(const std::exception& error) {
  return is_out_of_memory(error) ? out_of_memory_message : error.what();
}

/// 1: the program or a library has failed. 3: the same for a run that left the range of its model. 5: a signal asked
/// the run to stop; its state is saved.
enum ExitCode {
  exit_done = 0,
  exit_failed = 1,
  exit_input = 2,
  exit_no_convergence = 3,
  exit_resource = 4,
  exit_interrupted = 5
};

}  // namespace voussoir
