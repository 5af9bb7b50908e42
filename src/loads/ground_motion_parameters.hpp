// Acceleration of the ground, as inertia forces -density x volume x a(t) in the frame that moves with it.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"
#include "loads/record_layout_parameters.hpp"

namespace voussoir {

/// Of records; words and sizes are in loads/acceleration_unit.hpp.
enum class AccelerationUnit { m_per_s2, g, cm_per_s2, gal, mm_per_s2 };

struct GroundMotionParameters : LoadKindParameters {
  static constexpr const char* word = "ground motion";
  static constexpr const char* text = "Shaking of the ground, felt as inertia in the frame that moves with it";
  std::string record_x, record_y, record_z;            ///< files of accelerations over time
  RecordLayoutParameters layout;                       ///< of all
  int column_x = 0, column_y = 0, column_z = 0;        ///< of rows with more than two numbers, from 1
  AccelerationUnit unit = AccelerationUnit::m_per_s2;  ///< of all records
  double scale = 1.0;                                  ///< [-] times all records
  bool corrected = false;               ///< a linear acceleration is taken off: the ground ends at rest where it began
  double ax = 0.0, ay = 0.0, az = 0.0;  ///< [m/s2] added; for a time function

  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<FileOfLoad> files() {
    return {{"x record", &record_x}, {"y record", &record_y}, {"z record", &record_z}};
  }
};

}  // namespace voussoir
