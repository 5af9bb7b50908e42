// The motion of a block as a whole that is nearest to what its nodes do (least squares).
#pragma once

#include <algorithm>
#include <cmath>

#include "blocks/structure.hpp"

namespace voussoir {

/// A small motion of a plane block: of its middle, and a rotation about it.
struct RigidMotion {
  Vector<2> middle{}, mean{};  ///< [m] where the middle of its nodes is, and how it moves
  double rotation = 0;         ///< [-] counter-clockwise, of a small motion
  double turn = 0;             ///< [rad] the same of a motion that may be large
  double radius = 0;           ///< [m] of the node farthest from the middle

  Vector<2> at(const Vector<2>& x) const {
    const Vector<2> r = x - middle;
    return {mean[0] - rotation * r[1], mean[1] + rotation * r[0]};
  }
};

/// @param position  of all local node copies [m]
/// @param motion    of all local node copies [m, 2 x nodes]
inline RigidMotion rigid_motion(const std::vector<Vector<2>>& position, const LocalBlock<2>& block,
                                const std::vector<double>& motion) {
  RigidMotion rigid;
  const int first = block.first_local, count = static_cast<int>(block.mesh.position.size());
  const auto of_node = [&](int i) { return Vector<2>{motion[2 * i], motion[2 * i + 1]}; };
  // From the first node, so that the middle is one wherever the origin lies.
  for (int i = first; i < first + count; ++i) {
    rigid.middle = rigid.middle + (1.0 / count) * (position[i] - position[first]);
    rigid.mean = rigid.mean + (1.0 / count) * of_node(i);
  }
  rigid.middle = position[first] + rigid.middle;
  double moment = 0, inertia = 0, stretch = 0;
  for (int i = first; i < first + count; ++i) {
    const Vector<2> r = position[i] - rigid.middle;
    moment += cross(r, of_node(i) - rigid.mean);
    inertia += dot(r, r);
    stretch += dot(r, of_node(i) - rigid.mean);
    rigid.radius = std::max(rigid.radius, norm(r));
  }
  if (inertia > 0) rigid.rotation = moment / inertia;
  rigid.turn = std::atan2(moment, inertia + stretch);
  return rigid;
}

}  // namespace voussoir
