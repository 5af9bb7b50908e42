// What ranks send those who solve patches: of the unknowns and points that each owns; and are sent, of what became of
// them.
#pragma once

#include <vector>

#include "base/ids.hpp"
#include "linalg/types.hpp"
#include "nonlinear/patch_parts.hpp"

namespace voussoir {

/// Numbers of unknowns and points are those of the whole structure, -1 where a support holds.
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
    int shares;  ///< how many
    PointOfPatch point;
  };
  struct Share {  ///< of points, in their order
    GlobalOrdinal unknown;
    int component;
    double weight;
  };
  struct Motion {
    GlobalOrdinal id;
    double by;  ///< [m]
  };
  struct Force {
    PointId id;
    double change[3];  ///< [N] of which the plane has two
  };
};

}  // namespace voussoir
