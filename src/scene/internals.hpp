// How a step is solved: every number and switch that decides it, for studies. Section "internals" of a scene.
//
// None of them changes what is computed beyond its tolerances. They are no part of the documented scene: a user who
// needs one to reach a solution has found a fault of the program. `voussoir --print-internals` lists them with unit,
// range, default, meaning and reason; drivers/ablation shows which of them matter.
#pragma once

#include "homogenisation/coarse_operator_parameters.hpp"
#include "nonlinear/method_parameters.hpp"
#include "selection/rest_parameters.hpp"
#include "step/step_parameters.hpp"
#include "ties/tie_parameters.hpp"
#include "time/time_step_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct Internals {
  MethodParameters methods;
  CoarseOperatorParameters preconditioner;
  RestParameters rest;
  StepParameters step;
  TimeStepParameters time_step;
  TieParameters ties;
  void declare(ParameterSection&);
};

}  // namespace voussoir
