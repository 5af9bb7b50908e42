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

/// Of a load step, in which no time passes: it begins and ends with the same loads.
inline StepInTime at_rest(double time, const std::map<std::string, double>& factors) {
  return {time, time, factors, factors};
}

}  // namespace voussoir
