// Joints between stones: where facets of two stones face each other closely enough.
#pragma once

#include <vector>

#include "stones/facets.hpp"

namespace voussoir {

/// The common part of two facets.
struct StoneJoint {
  std::array<int, 2> stone{}, facet{};  ///< the lower number of a stone first
  Vector<3> normal{};                   ///< from the first stone to the second
  std::vector<Places> pieces;           ///< convex, between the two planes, counter-clockwise seen against the normal
  double area = 0;                      ///< [m2]
  double opening = 0;                   ///< [m] mean distance of the planes, negative where the stones overlap
  double farthest = 0;                  ///< [m] largest distance of the planes, either way
  bool welded = false;                  ///< farther apart than joints are, and closed by welding (imprint.hpp)
};

struct StoneJoints {
  std::vector<StoneJoint> joints;  ///< in the order of stones and facets
  int slivers = 0;                 ///< left out because they are narrower than the tolerance
  double sliver_area = 0;          ///< [m2]
  double area() const;
};

/// Facets of two stones are a joint when their normals are opposed to within this angle: cos 5 degrees. Planes that
/// diverge by more are apart by the tolerance within twelve of it.
constexpr double opposed = 0.99619469809174555;

/// @param tolerance  [m] largest distance of the two planes at any corner of the joint, and its least mean width
StoneJoints find_joints(const std::vector<FacetedStone>&, double tolerance);
/// @param width  [m] the least mean width;  @param reach  [m] the largest distance
StoneJoints find_joints(const std::vector<FacetedStone>&, double width, double reach);

/// How many joints there are at another tolerance.
struct JointCount {
  double tolerance = 0;  ///< [m]
  int joints = 0;
  double area = 0;  ///< [m2]
};

/// From a hundredth to twenty times a tolerance: a number that stays the same over decades is that of the drawing.
std::vector<JointCount> count_joints(const std::vector<StoneSurface>&, double tolerance);

/// The tolerance in the middle of the longest row of equal counts (areas within 1e-3); 0 when no two neighbours agree.
double tolerance_on_plateau(const std::vector<JointCount>&);

}  // namespace voussoir
