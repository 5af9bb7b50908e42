// How the forces of points that soften change with their motions: what stability.hpp asks of them.
//
// With friction held at its size a point loses strength along its normal and along its shear alone; across the shear,
// in space, its force turns with the slip, which takes work. So softening has two directions at most, and a symmetric
// matrix of two rows in the plane and in space.
#pragma once

#include <array>

#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

/// Symmetric: normal, mixed, along the shear.
using Square = std::array<double, 3>;
using InTangents = std::array<double, 2>;

/// What a point resists with, and the root of what it softens by, which is along its normal and one direction.
struct PointTangent {
  PointStiffness resistance;
  Square softening{};
  bool softens = false;
  InTangents along{1, 0};   ///< of its shear
  InTangents onward{1, 0};  ///< in which it slips on
};

/// Along a direction of the tangents.
inline double component(const InTangents& direction, const double* tangential, int tangents) {
  double sum = direction[0] * tangential[0];
  for (int t = 1; t < tangents; ++t) sum += direction[t] * tangential[t];
  return sum;
}

/// Slip from where it counts [m].
InTangents slip_of(const NonlinearProblem&, int point, const PointField& lambda, const PointField& gap);

/// Of all points of this rank; of those that are not selected nothing.
std::vector<PointTangent> point_tangents(const NonlinearProblem&, const CurrentLaws&, const PointField& lambda,
                                         const PointField& gap);

}  // namespace voussoir
