// From a number of components that is known when the program runs to one that loops can be unrolled by.
#pragma once

#include <cmath>
#include <type_traits>

namespace voussoir {

/// f(std::integral_constant<int, components>()): 2 in the plane, 3 in space.
template <class F>
decltype(auto) with_components(int components, F&& f) {
  return components == 2 ? f(std::integral_constant<int, 2>()) : f(std::integral_constant<int, 3>());
}

/// Length of the vector that begins at v.
inline double length_of(const double* v, int components) {
  return components == 2 ? std::hypot(v[0], v[1]) : std::hypot(v[0], v[1], v[2]);
}

}  // namespace voussoir
