// What ranks tell each other of patches: of the unknowns and points that each owns, and what became of them.
#pragma once

#include <vector>

#include "base/ids.hpp"
#include "linalg/types.hpp"
#include "nonlinear/patch_parts.hpp"

namespace voussoir {

/// Numbers of unknowns and points are those of the whole structure, -1 where none.
template <int dim>
struct PatchMessages {
  struct Unknown {
    GlobalOrdinal id;
    int patch;
    double imbalance, start, proximal;
  };
  struct Entry {
    GlobalOrdinal row, column;
    double value;
  };
  struct Point {
    PointId id;
    int patch;
    bool border;
    GlobalOrdinal unknown[2 * dim];
    PatchPoint point;
  };
  struct Motion {
    GlobalOrdinal id;
    double by;  ///< [m]
  };
  struct Force {
    PointId id;
    double change[dim];  ///< [N]
  };
};

}  // namespace voussoir
