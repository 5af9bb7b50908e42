// What an engineer asks of a structure that stands: what its joints carry, how far that is from their edges and their
// friction, which of them are hinges or slide, what its supports bear. Once, at the end of a run in statics.
#pragma once

#include <string>

#include "model/model_of_blocks.hpp"
#include "output/result_json.hpp"
#include "step/adaptive_step.hpp"

namespace voussoir {

/// Writes joints.csv into the folder and returns its summary. Collective; throws ResourceError on all ranks.
/// @param load  [N] nodal loads of the state
template <int dim>
StaticsSummary write_statics(const ModelOfBlocks<dim>&, const AdaptiveStep&, const ContactState&,
                             const std::vector<double>& load, const std::string& folder);

}  // namespace voussoir
