// A contact problem written out: matrices and vectors in place of operators, for solvers of others.
//
// Unknowns are those of the selection that no support holds; held ones are at their prescribed values, and what they do
// stands in f and w. Forces are those of the points that may part. Both are numbered by nodes and points as the mesh
// has them, without regard to ranks. Mortar is a spring in series with contact: the way of each of its components is
// an unknown of its own, behind the others, whose row of M is the spring alone.
#pragma once

#include <vector>

#include "linalg/types.hpp"
#include "output/fclib_file.hpp"

namespace voussoir {

class ContactProblem;

/// The problem, and its unknowns and forces as they are. Joints must be dry: no cohesion, no tension strength, finite
/// friction. Collective.
/// @param x       [m] unknowns
/// @param lambda  [N] forces of points
FclibProblem stated(ContactProblem&, const TpetraVector& x, const std::vector<double>& lambda);

}  // namespace voussoir
