// Change of temperature of a set of blocks.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct TemperatureParameters : LoadKindParameters {
  static constexpr const char* word = "temperature";
  static constexpr const char* text = "Uniform change of temperature of blocks";
  std::string blocks = "all";  ///< a set of blocks
  double change = 0.0;         ///< [K]
  double expansion = 8e-6;     ///< [1/K] coefficient of thermal expansion
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<SetOfLoad> sets() const { return {{"blocks", blocks, true}}; }
};

}  // namespace voussoir
