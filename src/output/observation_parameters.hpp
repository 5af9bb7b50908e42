// A place whose motion a run writes down step by step, or a support with the force it bears.
#pragma once

#include <string>

namespace voussoir {

class ParameterSection;

struct ObservationParameters {
  enum class Place { nearest_node, mean, support };
  std::string blocks = "all";  ///< a set of blocks
  Place place = Place::nearest_node;
  double x = 0.0, y = 0.0, z = 0.0;  ///< [m] of the nearest node, undeformed; z in space
  double tolerance = 0.05;           ///< [m] largest distance to a node
  std::string support;               ///< of the scene, where the place is one
  void declare(ParameterSection&);
};

}  // namespace voussoir
