// Weight of every block: density x volume x gravity, downwards (-y, in space -z).
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct SelfWeightParameters : LoadKindParameters {
  static constexpr const char* word = "self weight";
  static constexpr const char* text = "Weight of every block";
  double gravity = 9.81;  ///< [m/s2]
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
};

}  // namespace voussoir
