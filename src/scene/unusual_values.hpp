// What is allowed in a scene and probably not meant: numbers whose unit was taken for another.
#pragma once

#include "base/warning.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// A warning for every number outside the range that is usual for it, and for every pair that is unusual together, as
/// their declarations say (Range::usually, ParameterSection::expect).
Warnings unusual_values(const Scene&);

}  // namespace voussoir
