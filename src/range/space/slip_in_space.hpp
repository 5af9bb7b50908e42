// Slips of stones in space beyond what points that were drawn together can tell.
#pragma once

#include "model/space/space_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// `slip_beyond_cell` where a point that presses has slipped by more than the distance to the next one of its joint;
/// out of range where the resultant of a joint, carried along by one of its stones, lies beyond the other, which no
/// support holds, by more than half a cell, and in no other stone round about. Collective.
RangeFindings look_at_slips(const SpaceModel&, const StepEnd&);

}  // namespace voussoir
