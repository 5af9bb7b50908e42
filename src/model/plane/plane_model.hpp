// A model of the plane.
#pragma once

#include "model/model_of_blocks.hpp"

namespace voussoir {

class PlaneModel : public ModelOfBlocks<2> {
 public:
  using ModelOfBlocks::ModelOfBlocks;
};

/// Of a model that is one of the plane.
inline Geometry<2> plane_geometry(const Model& model) { return std::get<Geometry<2>>(model.geometry()); }

}  // namespace voussoir
