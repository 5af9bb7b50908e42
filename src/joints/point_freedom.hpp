// What a point can take over from others at its place without moving (shared_forces.hpp).
#pragma once

#include "joints/contact_law.hpp"

namespace voussoir {

struct PointFreedom {
  bool normal = false, tangential = false;  ///< it is closed; it sticks
  PointLaw law;                             ///< as it is now
};

}  // namespace voussoir
