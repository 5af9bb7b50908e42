// What a run that is stopped before its end knows by then.
#pragma once

#include <string>

#include "dynamics/load_steps.hpp"
#include "output/result_json.hpp"
#include "run/load_factor_analysis.hpp"
#include "run/stop_signals.hpp"

namespace voussoir {

/// "stopped by a signal", or what else it was.
std::string why_stopped(Stop);

/// "stopped by a signal after 3 steps: ..." with the bracket of the load factor so far, or how far stages are passed.
/// @param search  null where the scene asks for none
std::string what_is_known(Stop, const LoadSteps&, const LoadFactorAnalysis* search, const RunSummary&);

}  // namespace voussoir
