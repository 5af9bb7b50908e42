// The rows a rank owns of a distributed vector, as a plain array.
#pragma once

#include "linalg/types.hpp"

namespace voussoir {

inline const double* local_view(const TpetraVector& v) { return v.getLocalViewHost(Tpetra::Access::ReadOnly).data(); }

/// For writing; do not hold it across a call that communicates the vector.
inline double* local_view_to_write(TpetraVector& v) { return v.getLocalViewHost(Tpetra::Access::ReadWrite).data(); }

}  // namespace voussoir
