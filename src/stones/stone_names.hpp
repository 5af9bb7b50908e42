// Every stone has a name of its own, by which a scene says what it means.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "stones/surface.hpp"

namespace voussoir {

struct StonesOfFile {
  std::string stem;  ///< name of the file, without ending
  std::vector<StoneSurface> stones;
};

/// The stones of all files. A name that several files give is what their program calls every stone
/// ("OpenSCAD_Model"): there the name of the file stands for it, or in front of it where the file has more stones.
/// Names that repeat all the same are numbered, which is told: a scene that means one of them must be able to say so.
std::vector<StoneSurface> with_names_that_differ(std::vector<StonesOfFile>, Warnings&);

}  // namespace voussoir
