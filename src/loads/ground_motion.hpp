// Records of the acceleration of the ground, and what their baseline does.
#pragma once

#include <string>

#include "loads/time_function.hpp"

namespace voussoir {

/// Where a ground at rest ends when it has followed a record, linear between its points.
struct Drift {
  double velocity = 0;           ///< [m/s] at the end
  double displacement = 0;       ///< [m] at the end
  double peak_velocity = 0;      ///< [m/s] largest at a point of the record
  double peak_displacement = 0;  ///< [m] likewise
  /// Velocity and displacement at the end over their peaks, the larger of the two [-].
  double share() const;
};
Drift drift_of(const PiecewiseLinear& acceleration);

/// Takes off the linear acceleration c0 + c1 t that leaves the ground at rest where it began, from the last zero before
/// to the first zero after all that is not zero: where a record is silent, before and after the motion, it stays so.
PiecewiseLinear with_corrected_baseline(const PiecewiseLinear& acceleration);

}  // namespace voussoir
