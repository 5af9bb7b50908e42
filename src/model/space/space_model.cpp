#include "model/space/space_model.hpp"

#include <cmath>

#include "base/check.hpp"

namespace voussoir {

/// The turn of a block would be three numbers, which nothing follows yet: scenes that ask for it are refused.
template <>
double ModelOfBlocks<3>::move_geometry(const std::vector<double>&) {
  VOUSSOIR_EXPECT(!"blocks are followed in the plane alone");
  return 0;
}

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
