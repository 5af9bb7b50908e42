// What is said of a file that gmsh could not mesh.
#pragma once

#include <string>

#include "base/child_process.hpp"
#include "base/error.hpp"

namespace voussoir {

/// Throws InputError about the file of a scene.
[[noreturn]] void refuse_file(const std::string& file, const std::string& why, const std::string& advice);

/// Throws InputError for a file that is not there.
void require_file(const std::string& file);

/// Throws what is to be said of a process of gmsh that gave no mesh: InputError where the file is to blame, else
/// ResourceError.
[[noreturn]] void refuse_end(const std::string& file, const ChildEnd&);

/// Does work; to what it refuses a line is added that may explain it.
/// @param hint  called then alone; gives the line, or "". Where it refuses too, what work said stands
template <class Hint, class Work>
auto with_hint(const Hint& hint, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::string line;
    try {
      line = hint();
    } catch (const InputError&) {
    }
    if (line.empty()) throw;
    throw InputError(error.what() + ("\n" + line));
  }
}

}  // namespace voussoir
