// Traction on a set of facets, dead (does not follow the deformation).
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct TractionParameters : LoadKindParameters {
  static constexpr const char* word = "traction";
  static constexpr const char* text = "Force per area on facets";
  std::string on;                       ///< a set of facets
  std::string blocks;                   ///< a set of blocks whose facets alone are meant; "" for all of the set
  double tx = 0.0, ty = 0.0, tz = 0.0;  ///< [Pa]
  double pressure = 0.0;                ///< [Pa] against the outward normal, added to (tx, ty, tz)
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<SetOfLoad> sets() const { return sets_of(on, blocks); }
  std::optional<FacetsOfLoad> facets() const;
};

}  // namespace voussoir
