// How much of its friction a plane patch uses, for shear and twist together.
//
// Theory  S. Goyal, A. Ruina, J. Papadopoulos, Wear 143 (1991) 307-330: the forces and twists that the friction of a
//         patch can bear are a convex set, bounded by those of its rigid motions. Of a load (Q, M) the share is
//             max over motions (v, w) of (Q v + M w) / sum of bound |v + w x arm|
#pragma once

#include <vector>

#include "base/tensor.hpp"

namespace voussoir {

/// A place that rubs.
struct RubbingPlace {
  Vector<2> place;  ///< [m]
  Vector<2> shear;  ///< [N]
  double bound;     ///< [N] the most that its shear can be; may be infinite
};

/// The share that the resultant of the shear uses of what these bounds can bear of it: 1 where all places slip in one
/// rigid motion of the patch, no more than 1 where no shear exceeds its bound. NaN where no place has any bound.
double friction_used(const std::vector<RubbingPlace>&);

}  // namespace voussoir
