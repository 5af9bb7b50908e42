// What is measured of every step of a model of the plane: slips, turns, stones in each other.
#pragma once

#include <vector>

#include "model/plane/plane_model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// Keep what does not change from step to step; the model must outlive them.
std::vector<RangeMeasure> measures_in_plane(const PlaneModel&);

}  // namespace voussoir
