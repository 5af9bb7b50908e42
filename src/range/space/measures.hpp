// What is measured of every step of a model in space: whether it has moved so little that nothing else need be.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "range/range_check.hpp"

namespace voussoir {

/// `not_measured_in_space` where something has moved by more than a tenth of half the smallest joint. Up to there
/// slips, turns and overlaps are small beside what the model tells; beyond, nothing measures them in space. Keep what
/// does not change from step to step; the model must outlive them.
std::vector<RangeMeasure> measures_in_space(const Model&);

}  // namespace voussoir
