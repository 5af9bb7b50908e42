// Units in which records of acceleration are published.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loads/ground_motion_parameters.hpp"

namespace voussoir {

/// Every unit under the word by which a scene gives it.
const std::vector<std::pair<std::string, AccelerationUnit>>& acceleration_units();
std::string word_of(AccelerationUnit);
/// [m/s2] of one unit.
double in_si(AccelerationUnit);

/// The unit that a heading names in brackets, behind "in units of" or behind "unit"; nothing where it names none, or
/// several of different size.
std::optional<AccelerationUnit> unit_named_in(const std::vector<std::string>& heading);

/// The heading says that what follows is no acceleration, but the velocity or the displacement of the ground.
bool names_other_motion(const std::vector<std::string>& heading);

}  // namespace voussoir
