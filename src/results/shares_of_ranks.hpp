// How evenly ranks share the work of a model.
#pragma once

#include "mesh/partition_quality.hpp"
#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

/// Of the blocks, as the partition weighs them: unknowns. Collective.
PartitionQuality partition_quality(const Model&);

/// [-] Selected points of a rank, the most over the mean. Collective.
double imbalance_of_selected(const Model&, const ContactState&);

}  // namespace voussoir
