// What gmsh tells of a STEP file, as bytes between its program and this one.
#pragma once

#include <string>
#include <vector>

#include "mesh/bytes.hpp"
#include "stones/surface.hpp"

namespace voussoir {

struct StepSolids {
  std::vector<StoneSurface> stones;
  std::string failure;  ///< what gmsh said; empty where the file could be read
};

/// Writes or reads.
/// @param solids  const when they are written
template <class Bytes, class Solids>
void exchange(Bytes& bytes, Solids& solids) {
  plain_list(bytes, solids.failure);
  const std::size_t stones = bytes.size(solids.stones, sizeof(std::size_t));
  for (std::size_t k = 0; k < stones; ++k) {
    plain_list(bytes, solids.stones[k].name);
    bytes.plain(solids.stones[k].curved);
    plain_list(bytes, solids.stones[k].points);
    const std::size_t faces = bytes.size(solids.stones[k].faces, sizeof(std::size_t));
    for (std::size_t f = 0; f < faces; ++f) plain_list(bytes, solids.stones[k].faces[f]);
  }
}

}  // namespace voussoir
