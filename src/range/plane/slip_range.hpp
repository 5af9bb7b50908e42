// Slips beyond what pairs of nodes can tell.
#pragma once

#include "model/plane/plane_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// `slip_beyond_cell` as soon as a point that presses has slipped by more than the edges beside it: then another piece
/// of face is opposite. Out of range where the force has left the faces that touch, those of other stones that continue
/// them flush included. Collective.
RangeFindings look_at_slips(const PlaneModel&, const StepEnd&);

}  // namespace voussoir
