// Turns of stones beyond what first order can tell, against the stability that they have.
#pragma once

#include "model/model_of_blocks.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// Moments that turned stones add, which small rotations leave out, against what the joints can bear:
/// `turn_beyond_first_order` from a tenth on, out of range from the whole on. Collective.
/// @param smallest_half_joint  [m] of the structure: motions small against it are not looked at closely
template <int dim>
RangeFindings look_at_turns(const ModelOfBlocks<dim>&, const StepEnd&, double smallest_half_joint);

}  // namespace voussoir
