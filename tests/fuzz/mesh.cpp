// Meshes of gmsh in format 4.1: refused, or blocks that can be looked at.
#include <Teuchos_DefaultSerialComm.hpp>

#include "fuzz.hpp"
#include "mesh/gmsh_reader.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace voussoir;
  GmshParameters gmsh;
  static const std::string file = fuzz::scratch_file(".msh");
  gmsh.file = file;
  fuzz::write_file(file, bytes, count);
  const Teuchos::SerialComm<int> comm;
  fuzz::refuse_or_read([&] { read_gmsh(gmsh, comm); });
  std::remove(file.c_str());
  return 0;
}
