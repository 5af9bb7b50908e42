#include "model/plane/plane_model.hpp"

#include <cmath>

#include "base/check.hpp"
#include "base/finite.hpp"
#include "model/phase.hpp"

namespace voussoir {

template <>
double ModelOfBlocks<2>::wave_speed(int block) const {
  const auto& material = structure_->blocks()[block].material;
  return std::sqrt(plane_elasticity(material, structure_->model().plane)[0][0] / material.density);
}

template <>
double ModelOfBlocks<2>::move_geometry(const std::vector<double>& displacement) {
  VOUSSOIR_EXPECT(displacement.size() == 2 * static_cast<std::size_t>(structure_->nodes()) &&
                  "displacement: of node copies");
  VOUSSOIR_EXPECT(all_finite(displacement) && "displacement: finite");
  Phase phase("blocks");
  ++arrangement_;
  const double turned = structure_->move_to(displacement);
  points_->turn_axes(*structure_);
  return turned;
}

/// A cell gives way at its node by its thickness times area over length, which is one of a square.
template <>
double ModelOfBlocks<2>::stiffness_beside(int node) const {
  const auto& material = structure_->blocks()[structure_->block_of_node()[node]].material;
  return material.young_modulus * thickness_of(material, structure_->model());
}

}  // namespace voussoir
