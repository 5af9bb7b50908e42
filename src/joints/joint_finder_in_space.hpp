// The points two blocks have in common, in space.
#pragma once

#include <vector>

#include "mesh/border.hpp"

namespace voussoir {

struct PointInSpace {
  VertexId vertex = 0;
  int node_i = 0, node_j = 0;  ///< node numbers within each block
  Vector<3> normal{};          ///< unit, outward of block i
  double area = 0;             ///< [m2] share of the faces that meet here
};

/// Points of the joint between two blocks, ascending by vertex, as points_of_joint in the plane. Each face gives every
/// corner the integral of its shape function, so areas sum to the joint.
/// @param border_i, border_j  border_facets() of each block alone
std::vector<PointInSpace> points_of_joint(const Block<3>& i, const std::vector<BorderFace>& border_i, const Block<3>& j,
                                          const std::vector<BorderFace>& border_j);

}  // namespace voussoir
