// Vectors at right angles to others.
#pragma once

#include <cstddef>
#include <vector>

namespace voussoir {

/// Takes off a vector what lies along orthonormal ones. Twice: of one that nearly depends on them the first time leaves
/// little beside its round-off, and that lies along them.
/// @param product  of two vectors, in which the others are orthonormal
template <class V, class Product>
void take_off(const std::vector<V>& orthonormal, const Product& product, V& v) {
  for (int twice = 0; twice < 2; ++twice)
    for (const auto& u : orthonormal) {
      const double along = product(u, v);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] -= along * u[i];
    }
}

}  // namespace voussoir
