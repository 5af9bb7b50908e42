#include "stones/gmsh_crash.hpp"

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "mesh/gmsh_program.hpp"

namespace voussoir {

std::string in_gmsh_child(const char* work, const std::string& request) {
  return ask_gmsh(work, request, [](const ChildEnd& end) {
    if (end.by == ChildEnd::By::request) throw ResourceError("Stopped while gmsh meshed stones.\n  Begin again.");
    if (end.by == ChildEnd::By::memory)
      throw ResourceError("gmsh was ended " + end.time_and_size() +
                          "\n  because it wanted more for the stones than half of what is free on this machine.\n"
                          "  Give a larger mesh > stones > element size, or free memory.");
    throw GmshCrash{end.by == ChildEnd::By::signal ? "gmsh crashed (" + end.signal() + ")" : "gmsh ended by itself"};
  });
}

}  // namespace voussoir
