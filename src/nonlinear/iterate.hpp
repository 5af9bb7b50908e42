// What a solve is given and moves: where stones are, what points bear, and what points that soften have gone through.
#pragma once

#include "joints/damage.hpp"
#include "linalg/types.hpp"
#include "nonlinear/point_field.hpp"

namespace voussoir {

/// The state of one step, wherever its parts are kept.
struct Iterate {
  TpetraVector& x;     ///< [m] unknowns
  PointField& lambda;  ///< [N] contact forces
  Damage& damage;      ///< empty where no joint softens
};

}  // namespace voussoir
