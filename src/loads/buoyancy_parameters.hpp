// Uplift of blocks below a water level.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct BuoyancyParameters : LoadKindParameters {
  static constexpr const char* word = "buoyancy";
  static constexpr const char* text = "Uplift of what is below a water level: the weight of the water it displaces";
  std::string blocks = "all";  ///< a set of blocks
  double level = 0.0;          ///< [m] height of the water
  double density = 1000.0;     ///< [kg/m3] of the water
  double gravity = 9.81;       ///< [m/s2]
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<SetOfLoad> sets() const { return {{"blocks", blocks, true}}; }
};

}  // namespace voussoir
