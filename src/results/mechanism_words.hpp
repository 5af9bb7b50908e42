// A mechanism in the words of masonry: which blocks move and how, which joints open like hinges, slide or part.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace voussoir {

/// Said of a motion of limit analysis that cannot do without dilatancy; nothing of others.
std::string of_slip_that_dilates(bool dilates);

/// Such as "2 of 5 blocks move, block 3 most, down and turning clockwise; joints that slide: block 1 / block 3".
/// In space "..., towards -y and turning about an axis along x through y = 0.2 m, z = 0.6 m". Collective.
/// @param motion  displacement of all nodes of this rank [m], of any size
std::string mechanism_in_words(const Model&, const std::vector<double>& motion);

}  // namespace voussoir
