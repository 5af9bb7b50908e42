// Stones that lie in each other where they have moved to.
#pragma once

#include "model/plane/plane_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// `stones_overlap` where the outlines of two stones lie deeper in each other than what counts as touching. Collective.
/// @param shortest_side  [m] per owned block, of its cells
/// @param smallest_side  [m] of the structure
RangeFindings look_at_outlines(const PlaneModel&, const StepEnd&, const std::vector<double>& shortest_side,
                               double smallest_side);

}  // namespace voussoir
