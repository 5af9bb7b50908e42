// A place whose motion a run writes down step by step.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct ObservationParameters {
  enum class Place { nearest_node, mean };
  std::string blocks = "all";  ///< a set of blocks
  Place place = Place::nearest_node;
  double x = 0.0, y = 0.0;  ///< [m] of the nearest node, undeformed
  double tolerance = 0.05;  ///< [m] largest distance to a node
  void declare(ParameterSection&);
};

}  // namespace voussoir
