// Acceleration of the ground, as inertia forces -density x volume x a(t) in the frame that moves with it.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct GroundMotionParameters : LoadKindParameters {
  static constexpr const char* word = "ground motion";
  static constexpr const char* text = "Shaking of the ground, felt as inertia in the frame that moves with it";
  std::string record_x, record_y;  ///< CSV files of rows time [s], acceleration
  bool in_g = false;               ///< unit of the records: standard gravity, else m/s2
  double scale = 1.0;              ///< [-] times both records
  bool corrected = false;          ///< a linear acceleration is taken off: the ground ends at rest where it began
  double ax = 0.0, ay = 0.0;       ///< [m/s2] added; for a time function

  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<FileOfLoad> files() { return {{"x record", &record_x}, {"y record", &record_y}}; }
};

}  // namespace voussoir
