// An approximate inverse, symmetric positive definite so that conjugate gradients stay conjugate gradients.
#pragma once

#include "linalg/types.hpp"

namespace voussoir {

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// z = M r on the map of the system.
  virtual void apply(const TpetraVector& r, TpetraVector& z) const = 0;
};

}  // namespace voussoir
