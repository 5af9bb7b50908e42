// What each effect costs a run.
#pragma once

#include <map>
#include <string>

#include "simulation/model.hpp"

namespace voussoir {

/// Calls, seconds and bytes of every effect the program knows, in play or not. Collective.
std::map<std::string, EffectSummary> effect_costs(const Model<2>&);

}  // namespace voussoir
