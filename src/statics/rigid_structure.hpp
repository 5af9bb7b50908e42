// A structure as limit analysis sees it: stones that do not deform, the points at which they may press and rub on each
// other, and what holds them.
//
// Plane; forces in [N], moments about the middle of a stone in [N m], lengths in [m].
#pragma once

#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

/// A force and a moment about the middle of a stone; of a motion: two velocities and a turn.
using Wrench = std::array<double, 3>;

struct RigidStone {
  Vector<2> middle{};
  double radius = 1;  ///< [m] of the node farthest from the middle
  Wrench fixed{};     ///< loads that stay as they are
  Wrench raised{};    ///< loads that are multiplied by the load factor
};

struct RigidContact {
  int stone_i = 0, stone_j = 0;
  Vector<2> arm_i{}, arm_j{};       ///< [m] from the middles of the stones to the point
  std::array<Vector<2>, 2> axis{};  ///< normal from i to j, tangent
  PointLaw law;
  int joint = 0;  ///< points of one joint have one number
};

/// A component of motion of a node that is held.
struct RigidSupport {
  int stone = 0;
  Vector<2> arm{};
  Vector<2> direction{};
  int name = 0;  ///< number of the support it belongs to
};

struct RigidStructure {
  std::vector<RigidStone> stones;
  std::vector<RigidContact> contacts;
  std::vector<RigidSupport> supports;
};

/// Force and moment of a force at a place of a stone.
inline Wrench wrench_of(const Vector<2>& arm, const Vector<2>& force) {
  return {force[0], force[1], cross(arm, force)};
}

/// Velocity of a place of a stone.
inline Vector<2> velocity_at(const Wrench& motion, const Vector<2>& arm) {
  return {motion[0] - motion[2] * arm[1], motion[1] + motion[2] * arm[0]};
}

/// Opening and slip at a point while its stones move [m/s].
inline Vector<2> relative_velocity(const RigidContact& c, const std::vector<Wrench>& motion) {
  const auto v = velocity_at(motion[static_cast<std::size_t>(c.stone_j)], c.arm_j) -
                 velocity_at(motion[static_cast<std::size_t>(c.stone_i)], c.arm_i);
  return {dot(v, c.axis[0]), dot(v, c.axis[1])};
}

}  // namespace voussoir
