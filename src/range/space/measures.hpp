// What is measured of every step of a model in space: slips, turns, and stones that lie in each other.
#pragma once

#include <vector>

#include "model/space/space_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// Keep what does not change from step to step; the model must outlive them.
std::vector<RangeMeasure> measures_in_space(const SpaceModel&);

}  // namespace voussoir
