// A model of space.
#pragma once

#include "model/model_of_blocks.hpp"

namespace voussoir {

class SpaceModel : public ModelOfBlocks<3> {
 public:
  using ModelOfBlocks::ModelOfBlocks;
};

}  // namespace voussoir
