// What the law makes of every point at the end of a step: open, stick or slip, and where slips count from. The only
// place where a state is judged so.
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

/// Where slips count from in the step that follows [m]: what has slipped is where its stones are, what has not stays
/// where it was. The place of its stones would be off by what a solve leaves of gaps, and where three stones meet slips
/// would contradict gaps, which are to vanish: forces would then run round between these stones that nothing asks for.
/// @return  empty where nothing rubs
PointField slip_origins(const Model&, const ContactState& state, const PointField& gap, const PointField& slip_before);

}  // namespace voussoir
