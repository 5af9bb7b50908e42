// gmsh at work for stones, in a process of its own that may crash.
#pragma once

#include <string>

namespace voussoir {

/// gmsh ended by itself or crashed, not for want of memory, and nobody asked it to.
struct GmshCrash {
  std::string how;
};

/// What a child answers to one of gmsh_work (mesh/gmsh_program.hpp). Throws GmshCrash, or ResourceError where memory
/// was short or the program is to stop.
std::string in_gmsh_child(const char* work, const std::string& request);

}  // namespace voussoir
