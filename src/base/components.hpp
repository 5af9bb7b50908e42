// From a number of components that is known when the program runs to one that loops can be unrolled by.
#pragma once

#include <type_traits>

namespace voussoir {

/// f(std::integral_constant<int, components>()): 2 in the plane, 3 in space.
template <class F>
decltype(auto) with_components(int components, F&& f) {
  return components == 2 ? f(std::integral_constant<int, 2>()) : f(std::integral_constant<int, 3>());
}

}  // namespace voussoir
