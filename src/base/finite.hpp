// Fields of numbers that are numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace voussoir {

inline bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace voussoir
