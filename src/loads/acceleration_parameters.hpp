// The same acceleration on every block, as an inertia force density x volume x (ax, ay), in space (ax, ay, az).
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct AccelerationParameters : LoadKindParameters {
  static constexpr const char* word = "acceleration";
  static constexpr const char* text = "The same force per mass on every block";
  double ax = 0.0, ay = 0.0, az = 0.0;  ///< [m/s2]
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
};

}  // namespace voussoir
