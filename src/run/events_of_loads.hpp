// What loads do between the steps of time, and at the seams of stages.
#pragma once

#include "base/warning.hpp"
#include "dynamics/load_steps.hpp"
#include "dynamics/step_control.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Before a time step: an automatic one is no longer than what the loads of its stage ask for that vary within it.
void look_ahead(StepControl&, const Model&, const LoadSteps&);

/// Of a stage whose time step is given: is it longer than the time in which a load of it varies?
Warnings warnings_of_time_step(const Model&, const LoadSteps&);

/// A support that is elsewhere from one moment to the next has an infinite speed. Throws InputError on every rank alike
/// where a scene asks for that in a stage with a duration.
void refuse_jumps_of_supports(const Scene&, const Model&);

}  // namespace voussoir
