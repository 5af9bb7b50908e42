// What moves most in a motion.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "output/result_json.hpp"

namespace voussoir {

/// The block that moves most in a motion. Collective.
/// @param motion  displacement of all nodes of this rank [m], of any size
MechanismSummary largest_mover(const Model&, const std::vector<double>& motion);

}  // namespace voussoir
