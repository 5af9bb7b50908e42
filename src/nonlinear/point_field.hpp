// Forces, gaps and slips of contact points.
#pragma once

#include <vector>

namespace voussoir {

/// One number per contact point and direction, row-major [points x components]; component 0 is normal.
using PointField = std::vector<double>;

}  // namespace voussoir
