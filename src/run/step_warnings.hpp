// What a step that stands leaves open, be it a load step, a time step or an attempt at a load factor.
#pragma once

#include <string>
#include <utility>

#include "step/joint_strength.hpp"
#include "step/step.hpp"
#include "step/tie_balance.hpp"

namespace voussoir {

/// @param when  stage and load factor or time
inline Warnings warnings_of(const StepReport& report, const std::string& when) {
  auto all = held_by_ties(report.tied_share, report.tied_block, when);
  for (auto& warning : lost_on_the_way(report.newton.lost_on_the_way, when)) all.push_back(std::move(warning));
  return all;
}

}  // namespace voussoir
