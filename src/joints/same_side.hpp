// Where a border turns by more than 20 degrees a node has two points, one of each side; where it bends by less, one.
#pragma once

#include "base/tensor.hpp"

namespace voussoir {

/// Whether two normals, of any length, are of one side of a block.
template <std::size_t n>
bool on_same_side(const std::array<double, n>& a, const std::array<double, n>& b) {
  constexpr double cosine = 0.94;
  return dot(a, b) > cosine * norm(a) * norm(b);
}

}  // namespace voussoir
