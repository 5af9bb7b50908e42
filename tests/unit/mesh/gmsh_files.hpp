// Files of gmsh written for a test, and what reading them says.
#pragma once

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>

#include "mesh/gmsh_reader.hpp"
#include "support/repository.hpp"
#include "unit/mesh/mesh_facts.hpp"

namespace voussoir::test {

inline const std::string geo_folder = repository("/tests/unit/mesh/geo/");

inline std::unique_ptr<BlockSource<2>> read(const GmshParameters& p, Trust trust = Trust::no) {
  auto source = read_gmsh(p, *Tpetra::getDefaultComm(), trust);
  std::vector<BlockId> all(source->block_count());
  std::iota(all.begin(), all.end(), 0);
  source->bring(all, *Tpetra::getDefaultComm());  // every test looks at all blocks on every rank
  return source;
}

inline GmshParameters geo(const std::string& name) {
  GmshParameters p;
  p.file = geo_folder + name;
  return p;
}

/// A file written for one test, with the number of ranks in its name so that runs side by side do not meet.
inline GmshParameters written(const std::string& name, const std::string& text) {
  const auto comm = Tpetra::getDefaultComm();
  GmshParameters p;
  p.file = "np" + std::to_string(comm->getSize()) + "_" + name;
  if (comm->getRank() == 0) std::ofstream(p.file) << text;
  comm->barrier();
  return p;
}

inline std::string refusal(const GmshParameters& p) {
  return input_error([&] { read(p); });
}

inline const std::string square =
    "Point(1) = {0,0,0,1}; Point(2) = {1,0,0,1}; Point(3) = {1,1,0,1}; Point(4) = {0,1,0,1};\n"
    "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1}; Curve Loop(1) = {1,2,3,4};\n";

}  // namespace voussoir::test
