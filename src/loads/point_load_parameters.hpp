// A force at a point of the outside, given to the nearest node.
#pragma once

#include <string>
#include <vector>

#include "loads/load_kind_parameters.hpp"

namespace voussoir {

struct PointLoadParameters : LoadKindParameters {
  static constexpr const char* word = "point load";
  static constexpr const char* text = "A force at the node nearest to a point";
  double x = 0.0, y = 0.0, z = 0.0;     ///< [m] z in space
  double fx = 0.0, fy = 0.0, fz = 0.0;  ///< [N] in the plane on the modelled thickness; fz in space
  double tolerance = 0.05;              ///< [m] largest distance to a node
  std::string blocks = "all";           ///< a set of blocks, one of which bears it
  void declare(ParameterSection&);
  std::string summary() const;
  bool is_zero() const;
  std::vector<KeyOfSpace> keys_of_space() const;
  std::vector<SetOfLoad> sets() const { return {{"blocks", blocks, true}}; }
};

}  // namespace voussoir
