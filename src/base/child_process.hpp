// Work done in a process of its own, for libraries that may crash on what they are given.
//
// A process that uses MPI must not be copied: what the copy holds of it (connections, pinned memory, threads) is
// broken. So a program begins a second process before MPI, which waits, and each piece of work gets a copy of that one.
#pragma once

#include <functional>
#include <string>

namespace voussoir {

/// Begins the process that waits; the first thing a main program does, before MPI and before threads. It ends with this
/// one, however this one ends.
void begin_child_processes();

/// What a child does with the bytes it is sent; its answer is bytes too. It sees this program as it was when
/// begin_child_processes() was called, no variable as it is now, and ends without the ends of libraries.
using ChildWork = std::string (*)(const std::string& request);

/// Runs `work` in a child and returns its answer. An InputError of the child is thrown here too, anything else it
/// throws becomes a ResourceError. A program that has begun no child processes does the work itself, and crashes with
/// it.
/// @param died  throws what is to be said when the child is ended by a signal; given its name, "Segmentation fault"
std::string in_child_process(ChildWork work, const std::string& request,
                             const std::function<void(const std::string& signal)>& died);

}  // namespace voussoir
