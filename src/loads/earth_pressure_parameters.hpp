// Lateral pressure of soil on edges or faces: horizontal, a coefficient times the vertical stress of the soil.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct EarthPressureParameters : LoadKindParameters {
  static constexpr const char* word = "earth pressure";
  static constexpr const char* text = "Lateral pressure of soil, horizontal: K (unit weight x depth + surcharge)";
  enum class State { at_rest, active, passive, given };
  std::string on;             ///< a set of facets
  std::string blocks;         ///< a set of blocks whose facets alone are meant; "" for all of the set
  double unit_weight = 18e3;  ///< [N/m3] of the soil
  double surface = 0.0;       ///< [m] height of the surface of the soil
  double surcharge = 0.0;     ///< [Pa] on that surface
  State state = State::at_rest;
  double friction_angle = 30;  ///< [degrees] of the soil
  double given = 0.5;          ///< [-] K when given
  /// [-] Horizontal by vertical stress: Jaky at rest, Rankine else.
  double coefficient() const;
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<SetOfLoad> sets() const { return sets_of(on, blocks); }
  std::optional<FacetsOfLoad> facets() const;
};

}  // namespace voussoir
