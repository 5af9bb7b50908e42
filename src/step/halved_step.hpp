// Would half a load step be any easier than the whole?
#pragma once

#include <vector>

#include "dynamics/load_steps.hpp"
#include "model/construction.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Whether the next smaller load step of a stage asks the same as the one that failed, so that it fails as well:
///   - its loads and settlements are the same, as in a stage that only takes blocks away;
///   - or they are a multiple of those of the step, from a structure at rest without forces. Where stones stand where
///     they were drawn, joints are closed as drawn and have neither cohesion nor tension strength, a multiple of an
///     equilibrium is the equilibrium under that multiple of the loads: what falls under its weight falls under half.
/// Collective.
/// @param load, prescribed  of the step that failed [N], [m]
/// @param at_the_start      it failed with stones where they stood at its start, as always with small rotations
bool half_asks_the_same(const Model&, const Construction&, const LoadSteps&, const ContactState& before,
                        const std::vector<double>& load, const std::vector<double>& prescribed, bool at_the_start);

}  // namespace voussoir
