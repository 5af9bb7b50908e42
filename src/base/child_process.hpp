// Work done in a process of its own, for libraries that may crash on what they are given, or that only some scenes
// need: to load one takes as long as a small scene does, and memory in every rank.
//
// A process that uses MPI must not be copied: what the copy holds of it (connections, pinned memory, threads) is
// broken. So such work is a program of its own (serve_works). It is begun when first asked, waits, and each piece of
// work gets a copy of that process, which has loaded its libraries once.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace voussoir {

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

/// What a child does with the bytes it is sent; its answer is bytes too. It ends without the ends of libraries.
using ChildWork = std::string (*)(const std::string& request);

/// What a program that works does, all of its main(): it waits for requests of the one that began it and ends with
/// that, however that ends (the kernel kills it). Returns the exit code when somebody else began it.
/// @param works  by their names
int serve_works(int argc, char** argv, const std::map<std::string, ChildWork>& works);

/// Has a piece of work done in a child of a program that works, and returns its answer. An InputError of the child is
/// thrown here too, anything else it throws becomes a ResourceError, and so does a program that is not found: it is
/// looked for beside this one, where it is built or installed, and on PATH. What a child takes is bounded by what the
/// machine has free.
/// @param program  its file name
/// @param work     the name that serve_works() knows
/// @param died     throws what is to be said of a child that gave no answer
std::string in_child_process(const std::string& program, const std::string& work, const std::string& request,
                             const std::function<void(const ChildEnd&)>& died);

}  // namespace voussoir
