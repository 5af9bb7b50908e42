// Exact line search along a Newton direction of a convex, piecewise quadratic function.
#pragma once

#include <functional>

namespace voussoir {

/// Step in (0, 1] at which the slope vanishes; 1 when it is not yet positive there.
/// @param slope  derivative along the direction, non-decreasing in the step; negative at 0
inline double exact_step(const std::function<double(double)>& slope) {
  const double at_start = slope(0.0);
  // 1e-10 of the first slope is round-off of the sums behind it.
  if (slope(1.0) <= -1e-10 * at_start) return 1.0;
  double low = 0, high = 1;
  for (int k = 0; k < 24; ++k) {  // 2^-24: a step is known far better than Newton can use
    const double middle = (low + high) / 2;
    (slope(middle) > 0 ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace voussoir
