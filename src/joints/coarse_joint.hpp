// How far points overrate the strength of a brittle joint that has few cells along it.
//
// Forces are lumped at points: the one at the edge of a joint of n cells stands for half a cell, and stress that varies
// linearly over the depth, +-s at the edges, gives it the mean weighted by its shape function, s (1 - 2 / (3 n)). A
// joint that bends is thus overrated by 29 % with three cells, 12.5 % with six, 6 % with twelve. What is compared here
// is the stress that the forces of all points would have at the edge if it were linear along the joint (Navier).
//
// A joint of the plane has one axis, along it. One in space has two, those of the least rectangle around it, and bends
// about both; where it has six cells or more along one its bending along that is taken as its points show it.
#pragma once

#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// From this number of cells on a joint is fine enough: bending is then overrated by no more than 12.5 %.
constexpr int cells_of_a_fine_joint = 6;

/// A plane joint as a section through a beam.
struct JointSection {
  double area = 0;                           ///< [m2]
  Vector<2> middle{};                        ///< [m] its centroid, along its axes
  std::array<Vector<2>, 2> second_moment{};  ///< [m4] about the middle; of one axis [0][0] alone
  Vector<2> length{};                        ///< [m] along its axes
  std::array<int, 2> cells{};                ///< along its axes; 0 along the second where there is one alone

  int axes() const { return cells[1] > 0 ? 2 : 1; }
  bool is_fine() const;
};

/// A point of a brittle joint.
struct BrittlePoint {
  Vector<2> place{};        ///< [m] along the axes
  double area = 0;          ///< [m2] its share
  double normal_force = 0;  ///< [N] compression positive
  Vector<2> shear{};        ///< [N] along the axes
  double opened = 0;        ///< [m] the widest it has been; asked of points with two axes
  bool broken = false;      ///< its strength is lost
};

struct CoarseJoint {
  double overrating = 0;  ///< [-] of its strength, at most; 0 where nothing speaks for any
  double edge_use = 0;    ///< [-] of its strength, at the edge by linear stress
  double point_use = 0;   ///< [-] of its strength, at the point that bears most
};

/// Whether the strength of a joint may be overrated, by one of three signs. With tension strength: an edge stress that
/// exceeds that of the points, once it comes to half of the strength. With cohesion alone: an edge that would be open
/// by linear stress but counts as closed, once the shear comes to half of what the joint bears. With either: a point
/// that has broken in bending, or, of cohesion alone, in the shear of a beam.
/// @param points   of one plane joint, at least one, in any order, some at the corners of the section
/// @param tension, cohesion  [Pa] strength, one of them positive; may be infinite
/// @param friction [-] coefficient
CoarseJoint coarse_joint(const JointSection&, const std::vector<BrittlePoint>& points, double tension, double cohesion,
                         double friction);

}  // namespace voussoir
