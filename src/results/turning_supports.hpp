// Work of reactions on supports that turn, beyond that of the mean of two reactions along the chord of their way.
//
// A support moves what it holds of a stone as a body: its middle by v, and turned by an angle t about an axis through
// that. Reactions do work of their mean on v, and their moment M about the axis does the integral of M over the angle.
// Under loads that keep their direction, on a structure that turns with the support, M(t) = M0 cos t + D sin t, so that
// this integral is (M0 + M1) tan(t / 2), of the moments at both ends, whatever t is. Where reactions turn with the
// support it is off by t^2 / 12 of itself, which shorter steps make smaller.
#pragma once

#include <vector>

#include "model/contact_state.hpp"
#include "model/model.hpp"

namespace voussoir {

/// [J] of what this rank owns; 0 with small rotations, along whose straight ways the chord is all.
/// @param reaction_before, reaction  [N] on local node copies
double beyond_the_chord(const Model&, const ContactState& before, const ContactState& after,
                        const std::vector<double>& reaction_before, const std::vector<double>& reaction);

}  // namespace voussoir
