// Forces and moments on stones shared out among the joints: stones are rigid, joints are springs.
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// Ways a stone can move: along the axes and about them; in the plane about one.
template <int dim>
constexpr int ways_of_network = dim == 2 ? 3 : 6;
template <int dim>
using NetworkLoad = std::array<double, ways_of_network<dim>>;

/// A joint as a spring against parting, sliding and turning at its middle.
template <int dim>
struct NetworkJoint {
  int i = -1, j = -1;            ///< stones; -1 for what does not move
  Vector<dim> arm_i{}, arm_j{};  ///< [m] from the centres of the stones to the middle of the joint
  /// The normal, from i to j, and tangents; in the plane the normal turned by +90 degrees.
  std::array<Vector<dim>, dim> axis{};
  /// Along each axis, then of turning, in space about each axis; joints without bear nothing.
  NetworkLoad<dim> stiffness{};
};

/// The force on stone j along each axis of the joint, compression > 0, and its moment, in space about each axis.
template <int dim>
using NetworkForce = NetworkLoad<dim>;

/// What the joints bear so that every stone is in equilibrium: of all ways the one of least energy of the springs, that
/// is of least squares weighted by one over their stiffness. What no joint can bear is left unborne.
/// @param load  per stone: force along the axes and moments about its centre
template <int dim>
std::vector<NetworkForce<dim>> borne_by_network(int stones, const std::vector<NetworkJoint<dim>>&,
                                                const std::vector<NetworkLoad<dim>>& load);

}  // namespace voussoir
