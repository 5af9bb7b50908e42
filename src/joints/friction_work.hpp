// What friction takes at one contact point.
//
// Convention   src/README.md, "Contact": slip is opposite to the force where it reaches its bound.
// Return mapping of a step is implicit: the force at its end is there while the point slips, so the work of a step is
// that force times the slip, and no step gives anything back.
#pragma once

#include <algorithm>

#include "base/tensor.hpp"

namespace voussoir {

/// Work that friction takes in a step [J], never negative. A point that sticks takes none: its slip is what the solver
/// leaves, of any sign.
/// @param bound      [N] of the tangential force at the end of the step
/// @param force      [N] tangential, at the end
/// @param slip       [m] in the step
/// @param stiffness  [N/m] of the cells beside the point: a slip worth less than the force lacks to its bound is none
template <std::size_t n>
double friction_work(double bound, const std::array<double, n>& force, const std::array<double, n>& slip,
                     double stiffness) {
  if (norm(force - stiffness * slip) < bound) return 0;
  return std::max(0.0, -dot(force, slip));
}

}  // namespace voussoir
