// Forces and moments on stones shared out among the joints: stones are rigid, joints are springs.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// A joint as a spring against parting, sliding and turning at its middle.
struct NetworkJoint {
  int i = -1, j = -1;                 ///< stones; -1 for what does not move
  Vector<2> arm_i{}, arm_j{};         ///< [m] from the centres of the stones to the middle of the joint
  Vector<2> normal{};                 ///< unit, from i to j
  std::array<double, 3> stiffness{};  ///< of parting, sliding, turning; joints without bear nothing
};

/// Normal force (compression > 0), shear along the normal turned by +90 degrees and moment on stone j.
using NetworkForce = std::array<double, 3>;

/// What the joints bear so that every stone is in equilibrium: of all ways the one of least energy of the springs, that
/// is of least squares weighted by one over their stiffness. What no joint can bear is left unborne.
/// @param load  per stone: force x, y and moment about its centre
std::vector<NetworkForce> borne_by_network(int stones, const std::vector<NetworkJoint>&,
                                           const std::vector<std::array<double, 3>>& load);

}  // namespace voussoir
