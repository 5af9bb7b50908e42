// Which joint goes first where several are alike: the one with the point of the lowest number, the same on any
// number of ranks. Nothing of the structure tells that one from the others, so who chooses by it says how many there
// were.
#pragma once

#include <vector>

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

struct FirstOfAlike {
  long long number = -1;  ///< of the point; -1 where the field is 0 everywhere
  int joint = -1;         ///< on this rank; -1 where it has none of its points
  int joints = 0;         ///< that have a point alike
};

/// @param field  of all points of this rank, not negative. Points are alike that are as large as any but for the share
///               to which softening is told (StabilityParameters::share_error). Collective.
FirstOfAlike first_of_alike(const NonlinearProblem&, const std::vector<double>& field);

}  // namespace voussoir
