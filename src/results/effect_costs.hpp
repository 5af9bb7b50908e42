// What each effect costs a run.
#pragma once

#include <map>
#include <string>

#include "model/loads_at_work.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Calls, seconds and bytes of every effect the program knows, in play or not. Collective.
/// @param points  contact points of this rank, with ghosts
std::map<std::string, EffectSummary> effect_costs(const Scene&, const LoadsAtWork&, const BlockSystem&,
                                                  long long points);
std::map<std::string, EffectSummary> effect_costs(const Scene&, const Model&);

}  // namespace voussoir
