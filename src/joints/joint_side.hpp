// A side of a joint: what follows each other without a corner, along which it could slide.
#pragma once

#include <limits>
#include <vector>

#include "joints/joint_statics.hpp"

namespace voussoir {

/// Points of a side, by their numbers in the joint; in the plane as they follow each other along their tangents.
struct JointSide {
  std::vector<int> points;
  bool closed = false;  ///< in the plane: it runs round and has no ends
};

/// What a side bears, as if it were straightened.
template <int dim>
struct SideStatics {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double pressing = 0;
  double edge_margin = nan, friction_margin = nan;
  Vector<dim> edge{};    ///< [m] next to the pressure, where there is an edge margin
  Vector<dim> middle{};  ///< [m]
  bool holds = false;    ///< has strength beside friction
  bool hinge = false;
};

/// A hinge of elastic stones has a compressed zone; with stress that grows linearly to the edge its resultant lies at a
/// third of it. A tenth of the joint is where three tenths of it are compressed.
constexpr double at_the_edge = 0.1;
/// Closed points stand open by what the solver leaves, 1e-13 m; openings of stones that move are millions of times
/// that.
constexpr double open_share = 1e-9;  // of the length

/// All points of a joint, in the plane along a direction.
JointSide whole_side(const std::vector<PointOfJoint<2>>&, const Vector<2>& along);
JointSide whole_side(const std::vector<PointOfJoint<3>>&, const Vector<3>& along);
/// The sides that facets make.
std::vector<JointSide> sides_of(const std::vector<PointOfJoint<2>>&, const std::vector<FacetOfJoint<2>>&);
std::vector<JointSide> sides_of(const std::vector<PointOfJoint<3>>&, const std::vector<FacetOfJoint<3>>&);

SideStatics<2> side_statics(const std::vector<PointOfJoint<2>>&, const JointSide&);
SideStatics<3> side_statics(const std::vector<PointOfJoint<3>>&, const JointSide&);

}  // namespace voussoir
