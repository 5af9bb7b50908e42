// What loads are asked about that act over a step of time.
#pragma once

#include <map>
#include <string>

namespace voussoir {

/// A step from one time to another, along which load factors go linearly.
struct StepInTime {
  double from, to;                           ///< [s]
  std::map<std::string, double> begin, end;  ///< factors by name
};

}  // namespace voussoir
