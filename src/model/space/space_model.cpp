#include "model/space/space_model.hpp"

#include <cmath>

namespace voussoir {

/// Of pressure waves.
template <>
double ModelOfBlocks<3>::wave_speed(int block) const {
  const auto& m = structure_->blocks()[block].material;
  const double nu = m.poisson_ratio, modulus = m.young_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  return std::sqrt(modulus / m.density);
}

/// A cell gives way at its node by area over length, its side where it is a cube: of others the side of the cube that
/// is as large.
template <>
double ModelOfBlocks<3>::stiffness_beside(int node) const {
  return structure_->blocks()[structure_->block_of_node()[node]].material.young_modulus * (*cell_size_)[node];
}

}  // namespace voussoir
