// People or goods on edges or faces: vertical force per horizontal area, on a part of it.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct CrowdParameters : LoadKindParameters {
  static constexpr const char* word = "crowd";
  static constexpr const char* text = "Vertical force per horizontal area on a part of an edge, in space of faces";
  std::string on;                      ///< a set of facets
  std::string blocks;                  ///< a set of blocks whose facets alone are meant; "" for all of the set
  double intensity = 5e3;              ///< [Pa] per horizontal area, downwards
  double x_from = -1e30, x_to = 1e30;  ///< [m]
  double y_from = -1e30, y_to = 1e30;  ///< [m] in space
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<SetOfLoad> sets() const { return sets_of(on, blocks); }
  std::optional<FacetsOfLoad> facets() const;
};

}  // namespace voussoir
