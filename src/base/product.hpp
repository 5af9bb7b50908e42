// The product of two lists of numbers of one length.
#pragma once

#include <cstddef>
#include <vector>

namespace voussoir {

inline double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace voussoir
