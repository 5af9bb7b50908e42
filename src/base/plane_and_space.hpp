// Vectors of the plane as those of space, without a third component, and back.
#pragma once

#include "base/tensor.hpp"

namespace voussoir {

inline Vector<3> in_space(const Vector<2>& a) { return {a[0], a[1], 0.0}; }
inline const Vector<3>& in_space(const Vector<3>& a) { return a; }
inline Vector<2> in_plane(const Vector<3>& a) { return {a[0], a[1]}; }

}  // namespace voussoir
