// Work done in a process of its own, for libraries that may crash on what they are given.
//
// A process that uses MPI must not be copied: what the copy holds of it (connections, pinned memory, threads) is
// broken. So a program begins a second process before MPI, which waits, and each piece of work gets a copy of that one.
#pragma once

#include <functional>
#include <string>

namespace voussoir {

/// Begins the process that waits; the first thing a main program does, before MPI and before threads. It and its
/// children end with this one, however this one ends: the kernel kills them.
void begin_child_processes();

/// While a child works the program asks so, every fifth of a second; once the answer is yes the child is ended, and
/// what was asked of it ends in a ResourceError.
void end_child_processes_when(bool (*asked_to_stop)());

/// How a child ended that gave no answer.
struct ChildEnd {
  enum class By {
    signal,   ///< such as by a mistake in a library, or by somebody
    itself,   ///< it ended before its work did
    memory,   ///< it wanted more than it is allowed
    request,  ///< the program was asked to stop
  };
  By by = By::itself;
  int number = 0;      ///< of the signal, or its exit code
  double seconds = 0;  ///< it worked
  double peak = 0;     ///< [bytes] it had at most
  double allowed = 0;  ///< [bytes]

  std::string signal() const;         ///< "Segmentation fault"
  std::string time_and_size() const;  ///< "after 12 s, with 0.3 GB"
};

/// What a child does with the bytes it is sent; its answer is bytes too. It sees this program as it was when
/// begin_child_processes() was called, no variable as it is now, and ends without the ends of libraries.
using ChildWork = std::string (*)(const std::string& request);

/// Runs `work` in a child and returns its answer. An InputError of the child is thrown here too, anything else it
/// throws becomes a ResourceError. A program that has begun no child processes does the work itself, and crashes with
/// it. What a child takes is bounded by what the machine has free.
/// @param died  throws what is to be said of a child that gave no answer
std::string in_child_process(ChildWork work, const std::string& request,
                             const std::function<void(const ChildEnd&)>& died);

}  // namespace voussoir
