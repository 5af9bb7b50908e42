// The contacts of a structure that bear whatever all of them can bear.
//
// A force at a point between the corners of a flat joint is shared by these in proportion, with the same force and
// moment on both stones; a dry joint admits each share, since its cones have their vertex at no force.
#pragma once

#include <vector>

#include "statics/rigid_structure.hpp"

namespace voussoir {

inline bool dry(const PointLaw& law) { return law.cohesion == 0 && law.tension == 0; }

/// Contacts by number in the structure: the corners of dry flat joints, which in the plane are the two ends of straight
/// ones, and every point of all others.
struct JointCorners {
  std::vector<int> kept;
  std::vector<int> first, count;  ///< per kept contact: the corners of its joint among the kept; one alone is no corner

  bool is_corner(std::size_t k) const { return count[k] > 1; }
};

template <int dim>
JointCorners joint_corners(const RigidStructure<dim>&);

}  // namespace voussoir
