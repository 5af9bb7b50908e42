// Stresses of cells from displacements.
#pragma once

#include <vector>

#include "blocks/structure.hpp"

namespace voussoir {

/// Mean stress (xx, yy, xy) of every cell of the owned blocks, cell by cell [Pa].
/// @param displacement  [m, dim x local node copies]
/// @param free_strain   what a block would take without stress in every direction of the plane, such as by heat
///                      [-, per local block]; empty for none
std::vector<double> cell_stresses(const Structure<2>&, const std::vector<double>& displacement,
                                  const std::vector<double>& free_strain);

}  // namespace voussoir
