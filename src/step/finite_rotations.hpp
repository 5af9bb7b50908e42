// Load steps in which stones may turn far: equilibrium where they stand, not where they were drawn.
//
// Solve, follow the stones to where they have moved and turned to, solve again under the same loads, until following
// turns no stone any more. Within one solve rotations are small ones about where stones stood before it.
#pragma once

#include "step/adaptive_step.hpp"

namespace voussoir {

/// Moves a state by one load step of a model, as AdaptiveStep takes it, with small or finite rotations as the scene
/// asks. Without an equilibrium the stones are back where the state before has them. Collective.
StepReport solve_load_step(Model&, AdaptiveStep&, ContactState&, const std::vector<double>& load,
                           const std::vector<double>& prescribed);

/// Puts the stones of a model that has followed a step back to where a state has them. Collective.
inline void go_back(Model& model, const ContactState& state) {
  if (model.settings().rotations == Rotations::finite) model.move_geometry(state.displacement);
}

}  // namespace voussoir
