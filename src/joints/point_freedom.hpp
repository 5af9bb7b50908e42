// What a point can take over from others at its place without moving (shared_forces.hpp).
#pragma once

#include <array>

#include "joints/contact_law.hpp"

namespace voussoir {

struct PointFreedom {
  bool normal = false, tangential = false;  ///< it is closed; it sticks
  std::array<double, 2> slope{};            ///< [-] tangential forces per normal force of one that slips
  PointLaw law;                             ///< as it is now
};

}  // namespace voussoir
