// What a step that stands leaves open, be it a load step, a time step or an attempt at a load factor.
#pragma once

#include <string>
#include <utility>

#include "step/joint_strength.hpp"
#include "step/step.hpp"
#include "step/step_parameters.hpp"
#include "step/tie_balance.hpp"

namespace voussoir {

/// Whether cracks grew in a jump within a step.
inline bool jumped(const StepReport& report, const StepParameters& numbers) {
  return report.newton.lost_on_the_way >= numbers.jump;
}

/// @param when  stage and load factor or time
inline Warnings warnings_of(const StepReport& report, const StepParameters& numbers, const std::string& when) {
  auto all = held_by_ties(report.tied_share, report.tied_block, when);
  if (!jumped(report, numbers)) return all;
  for (auto& warning : lost_on_the_way(report.newton.lost_on_the_way, when)) all.push_back(std::move(warning));
  return all;
}

}  // namespace voussoir
