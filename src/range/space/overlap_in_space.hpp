// Stones in space that lie in each other where they have moved to.
#pragma once

#include "model/space/space_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// `stones_overlap` where stones lie deeper in each other than what counts as touching. Collective.
/// @param smallest_side  [m] of the cells of the structure
RangeFindings look_at_overlaps(const SpaceModel&, const StepEnd&, double smallest_side);

}  // namespace voussoir
