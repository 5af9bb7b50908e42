// Records of the acceleration of the ground, and what their baseline does.
#pragma once

#include <string>

#include "loads/time_function.hpp"

namespace voussoir {

/// Where a ground at rest ends when it has followed a record, linear between its points.
struct Drift {
  double velocity = 0;       ///< [m/s] at the end
  double displacement = 0;   ///< [m] at the end
  double peak_velocity = 0;  ///< [m/s] largest at a point of the record
};
Drift drift_of(const PiecewiseLinear& acceleration);

/// Takes off the linear acceleration that leaves the ground at rest where it began.
PiecewiseLinear with_corrected_baseline(const PiecewiseLinear& acceleration);

}  // namespace voussoir
