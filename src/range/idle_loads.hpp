// Loads that change nothing: supports bear them where they act, or they have no force.
#pragma once

#include "base/warning.hpp"
#include "model/model.hpp"

namespace voussoir {

struct Scene;

/// A warning for every load of a stage or of the pattern of a load factor whose forces all act on held components of
/// nodes, or that presses on none of its facets: at any factor the structure stands as without it. Of loads that move
/// supports what they hold nothing of is told, of those that vary with time load steps at which they are 0. Collective.
Warnings warnings_of_idle_loads(const Scene&, const Model&);

}  // namespace voussoir
