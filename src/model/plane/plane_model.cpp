#include "model/plane/plane_model.hpp"

#include <cmath>

namespace voussoir {

template <>
double ModelOfBlocks<2>::wave_speed(int block) const {
  const auto& material = structure_->blocks()[block].material;
  return std::sqrt(plane_elasticity(material, structure_->model().plane)[0][0] / material.density);
}

/// A cell gives way at its node by its thickness times area over length, which is one of a square.
template <>
double ModelOfBlocks<2>::stiffness_beside(int node) const {
  const auto& material = structure_->blocks()[structure_->block_of_node()[node]].material;
  return material.young_modulus * thickness_of(material, structure_->model());
}

}  // namespace voussoir
