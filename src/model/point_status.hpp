// What the law makes of every point at the end of a step: open, stick or slip. The only place where a state is judged
// so.
#pragma once

#include <vector>

#include "model/contact_state.hpp"
#include "model/model.hpp"

namespace voussoir {

/// The trial force of a point is what it bears less what its stones, as it sees them, make of its gap and its slip:
/// that is what judge() of the law is asked about, with what friction bears under its pressure.
/// @param state        with the bonds that are left; ghosts of its forces up to date
/// @param gap          [m] gap and slip of the stones
/// @param slip_before  [m] that slips count from; empty for 0
/// @return  a PointStatus per point, of those that ties hold too
std::vector<char> point_statuses(const Model&, const ContactState& state, const PointField& gap,
                                 const PointField& slip_before);

}  // namespace voussoir
