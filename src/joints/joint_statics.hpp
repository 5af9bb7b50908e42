// What one joint carries, from the forces at its contact points: resultant, how far it is from the edge and from the
// friction cone, and whether the joint is a hinge or slides.
//
// Conventions  src/README.md, "Contact"; forces are those of block i on block j. The joint runs along the tangent of
//              its mean normal. The place of the resultant is where it crosses that line.
#pragma once

#include <vector>

#include "base/tensor.hpp"
#include "joints/contact_law.hpp"

namespace voussoir {

struct PointOfJoint {
  Vector<2> position{};     ///< [m]
  Vector<2> normal{};       ///< unit, from block i to block j
  double normal_force = 0;  ///< [N] compression positive
  double shear = 0;         ///< [N] along the normal turned by +90 degrees
  double gap = 0;           ///< [m] > 0 open
  PointLaw law;             ///< as it is now: what broke has no strength
};

struct JointStatics {
  Vector<2> force{};        ///< [N] on block j
  double normal_force = 0;  ///< [N] along the mean normal, compression positive
  double shear = 0;         ///< [N] along the joint
  double length = 0;        ///< [m] from its first point to its last
  Vector<2> middle{};       ///< [m]
  Vector<2> place{};        ///< [m] where the resultant crosses the joint; NaN without compression
  double eccentricity = 0;  ///< [m] from the middle to the place, along the joint; NaN without compression
  /// [-] Distance of the place from the nearer edge over the length: 0.5 in the middle, 0 at the edge, negative beyond
  /// it, where strength in tension holds; NaN without compression.
  double edge_margin = 0;
  /// [-] Share of the strength in shear that is left: 1 without shear, 0 when the whole joint slides; NaN where no
  /// shear could be borne.
  double friction_margin = 0;
  double opening = 0;   ///< [m] the widest gap, 0 when none is open
  bool hinge = false;   ///< open at one edge, the resultant at the other
  bool slides = false;  ///< nothing of its strength in shear is left
};

/// @param points  of one joint, at least one, in any order
JointStatics joint_statics(const std::vector<PointOfJoint>& points);

}  // namespace voussoir
