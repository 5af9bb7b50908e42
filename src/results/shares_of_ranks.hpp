// How evenly ranks share the work of a model.
#pragma once

#include "mesh/partition_quality.hpp"
#include "model/contact_problem.hpp"
#include "model/plane/plane_model.hpp"

namespace voussoir {

/// Of the blocks, as the partition weighs them: unknowns.
PartitionQuality partition_quality(const PlaneModel&);

/// [-] Selected points of a rank, the most over the mean. Collective.
double imbalance_of_selected(const PlaneModel&, const ContactState&);

}  // namespace voussoir
