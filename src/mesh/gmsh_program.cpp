#include "mesh/gmsh_program.hpp"

namespace voussoir {

std::string ask_gmsh(const char* work, const std::string& request, const std::function<void(const ChildEnd&)>& died) {
  return in_child_process("voussoir-gmsh", work, request, died);
}

}  // namespace voussoir
