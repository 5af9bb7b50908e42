// What one joint carries, from the forces at its contact points: resultant, how far it is from the edge and from the
// friction cone, and whether the joint is a hinge or slides.
//
// Conventions  src/README.md, "Contact"; forces are those of block i on block j. The resultant is told against the mean
//              normal of the joint; its place is where it crosses the tangent of that through the joint's middle.
//
// Margins are those of the sides of a joint: chains of facets without a corner, at which it could not slide along. A
// side that bends is measured as if it were straightened: the place of its pressure along it, the sum of the shear
// forces along it. So no margin is below zero where every point obeys its law, and none is zero but where all that
// presses is at an end, or all points slide one way. Of several sides the least margin is told.
#pragma once

#include <array>
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

/// A facet of a joint, as the numbers of the points at its ends.
using FacetOfJoint = std::array<int, 2>;

struct JointStatics {
  Vector<2> force{};        ///< [N] on block j
  double normal_force = 0;  ///< [N] along the mean normal, compression positive
  double shear = 0;         ///< [N] along the joint
  double pressing = 0;      ///< [N] sum of the normal forces of its points, each along its own normal
  double length = 0;        ///< [m] of the chord from its first point to its last
  Vector<2> middle{};       ///< [m]
  Vector<2> place{};        ///< [m] where the resultant crosses the joint; NaN without compression
  double eccentricity = 0;  ///< [m] from the middle to the place, along the joint; NaN without compression
  /// [-] Distance of the pressure from the nearer end of its side over the length of that: 0.5 in the middle, 0 at the
  /// end, negative beyond it, where strength in tension holds; NaN without compression.
  double edge_margin = 0;
  /// [-] Share of the strength in shear that is left: 1 without shear, 0 when the whole side slides, and where bonded
  /// points bear more than their law admits; NaN where no shear could be borne.
  double friction_margin = 0;
  int sides = 0;            ///< how many it has
  Vector<2> edge{};         ///< [m] the end from which the edge margin counts; NaN without one
  Vector<2> least_shear{};  ///< [m] middle of the side with the least friction margin; NaN without one
  double opening = 0;       ///< [m] the widest gap, 0 when none is open
  bool hinge = false;       ///< open at one edge, the pressure at the other
  bool slides = false;      ///< nothing of its strength in shear is left on any side that is pressed
};

/// @param points  of one joint, at least one, in any order
/// @param facets  between them; none: all points follow each other on one side
JointStatics joint_statics(const std::vector<PointOfJoint>& points, const std::vector<FacetOfJoint>& facets = {});

}  // namespace voussoir
