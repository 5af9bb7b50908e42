// The motion of a block as a whole that is nearest to what its nodes do (least squares).
#pragma once

#include <algorithm>
#include <cmath>

#include "base/rotation.hpp"
#include "blocks/structure.hpp"

namespace voussoir {

/// A small motion of a plane block: of its middle, and a rotation about it.
struct RigidMotion {
  Vector<2> middle{}, mean{};  ///< [m] where the middle of its nodes is, and how it moves
  double rotation = 0;         ///< [-] counter-clockwise
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
  double moment = 0, inertia = 0;
  for (int i = first; i < first + count; ++i) {
    const Vector<2> r = position[i] - rigid.middle;
    moment += cross(r, of_node(i) - rigid.mean);
    inertia += dot(r, r);
    rigid.radius = std::max(rigid.radius, norm(r));
  }
  if (inertia > 0) rigid.rotation = moment / inertia;
  return rigid;
}

/// A small motion of a block in space.
struct RigidMotionInSpace {
  Vector<3> middle{}, mean{};  ///< [m] as in the plane
  Vector<3> rotation{};        ///< [-] right-handed about its direction

  Vector<3> at(const Vector<3>& x) const { return mean + cross(rotation, x - middle); }
};

/// The rotation balances the moment of the motion about the middle, with each node of weight one.
inline RigidMotionInSpace rigid_motion(const std::vector<Vector<3>>& position, const LocalBlock<3>& block,
                                       const std::vector<double>& motion) {
  RigidMotionInSpace rigid;
  const int first = block.first_local;
  const auto of_node = [&](int i) { return Vector<3>{motion[3 * i], motion[3 * i + 1], motion[3 * i + 2]}; };
  for (int i = first; i < first + block.nodes; ++i) {
    rigid.middle = rigid.middle + (1.0 / block.nodes) * (position[i] - position[first]);
    rigid.mean = rigid.mean + (1.0 / block.nodes) * of_node(i);
  }
  rigid.middle = position[first] + rigid.middle;
  Vector<3> moment{};
  std::array<Vector<3>, 3> inertia{};
  for (int i = first; i < first + block.nodes; ++i) {
    const auto r = position[i] - rigid.middle;
    moment = moment + cross(r, of_node(i) - rigid.mean);
    for (int a = 0; a < 3; ++a) {
      inertia[a][a] += dot(r, r);
      for (int b = 0; b < 3; ++b) inertia[a][b] -= r[a] * r[b];
    }
  }
  const double determinant = dot(inertia[0], cross(inertia[1], inertia[2]));
  if (determinant > 0)  // else all nodes lie in a line
    for (int a = 0; a < 3; ++a)
      rigid.rotation = rigid.rotation + (moment[a] / determinant) * cross(inertia[(a + 1) % 3], inertia[(a + 2) % 3]);
  return rigid;
}

/// How far a block has turned with a motion, however large: as its nodes have in the mean.
/// @param position  of all local node copies [m]
/// @param motion    of all local node copies [m]
/// @param rigid     the small motion nearest to it, of whose middle and its motion this is
template <int dim, class Rigid>
Rotation<dim> nearest_rotation(const std::vector<Vector<dim>>& position, const LocalBlock<dim>& block,
                               const std::vector<double>& motion, const Rigid& rigid) {
  NearestRotation<dim> nearest;
  for (int i = block.first_local; i < block.first_local + block.nodes; ++i) {
    Vector<dim> moved;
    for (int c = 0; c < dim; ++c) moved[c] = motion[dim * i + c];
    nearest.add(position[i] - rigid.middle, moved - rigid.mean);
  }
  return nearest.found();
}

}  // namespace voussoir
