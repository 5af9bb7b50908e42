// Pressure of still water on edges or faces.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct WaterPressureParameters : LoadKindParameters {
  static constexpr const char* word = "water pressure";
  static constexpr const char* text = "Pressure of still water on facets below its level";
  std::string on;           ///< a set of facets
  std::string blocks;       ///< a set of blocks whose facets alone are meant; "" for all of the set
  double level = 0.0;       ///< [m] height of the water
  double density = 1000.0;  ///< [kg/m3]
  double gravity = 9.81;    ///< [m/s2]
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<SetOfLoad> sets() const { return sets_of(on, blocks); }
  std::optional<FacetsOfLoad> facets() const;
};

}  // namespace voussoir
