// Vectors of the plane as those of space, without a third component, and back.
#pragma once

#include "base/tensor.hpp"

namespace voussoir {

inline Vector<3> in_space(const Vector<2>& a) { return {a[0], a[1], 0.0}; }
inline const Vector<3>& in_space(const Vector<3>& a) { return a; }
inline Vector<2> in_plane(const Vector<3>& a) { return {a[0], a[1]}; }
template <int dim>
Vector<dim> in_dimension(const Vector<3>& a) {  // the first components: all of them in space
  if constexpr (dim == 2)
    return in_plane(a);
  else
    return a;
}

}  // namespace voussoir
