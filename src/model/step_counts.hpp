// What a step took and found, as its report has it.
#pragma once

#include "base/step_numbers.hpp"
#include "model/step.hpp"

namespace voussoir {

/// All numbers but those of the points by status, which the state after the step tells.
inline StepNumbers numbers_of(const StepReport& report) {
  const auto& newton = report.newton;
  StepNumbers n;
  n.selection_rounds = report.selection_rounds;
  n.newton_iterations = newton.newton_iterations;
  n.linear_solves = newton.newton_iterations + report.estimate_solves;
  n.failed_linear_solves = newton.failed_solves;
  n.krylov_iterations = newton.krylov_iterations;
  n.patch_solves = newton.local_solves;
  n.factorised = report.cost.factorised;
  n.factorised_whole = report.cost.whole;
  n.levels_built = report.cost.levels;
  n.levels_refused = report.cost.levels_refused;
  n.factors_reused = report.cost.reused;
  n.complementarity_residual = newton.complementarity;
  n.largest_penetration = newton.penetration;
  n.error_estimate = report.error_estimate;
  return n;
}

}  // namespace voussoir
