// Which stone bears what a load places at a point, and what to say where several could.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "loads/load.hpp"

namespace voussoir {

/// The warning that one of several stones at a place bears a load; nothing when there is only one. Collective: the
/// stones are the same on every rank, and the first can be asked of them.
/// @param what    kind of the warning
/// @param place   "the node nearest to (1, 2) m"
/// @param stones  that could bear it, the bearer among them; repeated and in any order
template <int dim>
Warnings warning_of_bearer(const LoadSite<dim>&, const std::string& what, const std::string& place,
                           std::vector<BlockId> stones, BlockId bearer);

}  // namespace voussoir
