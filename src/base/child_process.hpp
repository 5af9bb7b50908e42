// Work done in a process of its own, for libraries that may crash on what they are given.
#pragma once

#include <functional>
#include <string>

namespace voussoir {

/// Runs `work` in a copy of this process and returns the bytes it returns. An InputError of the copy is thrown here
/// too, anything else it throws becomes a ResourceError. The copy ends without the ends of libraries, so no work may
/// use MPI.
/// @param died  throws what is to be said when the copy is ended by a signal; given its name, "Segmentation fault"
std::string in_child_process(const std::function<std::string()>& work,
                             const std::function<void(const std::string& signal)>& died);

}  // namespace voussoir
