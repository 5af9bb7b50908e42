// What a point can take over from others at its place without moving (shared_forces.hpp).
#pragma once

#include <array>

#include "joints/contact_law.hpp"

namespace voussoir {

/// Whether friction of points that slip follows their pressure, at once in every split, or is held at places where it
/// would otherwise hide a way for forces to run round.
enum class SharedFriction { follows, held_where_it_hides };

struct PointFreedom {
  bool normal = false, tangential = false;  ///< it is closed; it sticks
  std::array<double, 2> slope{};            ///< [-] tangential forces per normal force of one that slips
  PointLaw law;                             ///< as it is now
};

}  // namespace voussoir
