// Openings of walls in space as cells of the wall's lattice, with the lintels over them.
#pragma once

#include <string>
#include <vector>

#include "mesh/masonry_parameters.hpp"

namespace voussoir {

/// Columns of cells and courses that an opening leaves free, or that a lintel takes.
struct WallRectangle {
  int from, to;      ///< columns
  int below, above;  ///< courses
  std::string name;  ///< of the opening
};

struct WallOpenings {
  std::vector<WallRectangle> free;
  std::vector<WallRectangle> lintels;  ///< each of one course; none over an opening that reaches the top
};

/// Throws InputError for an opening whose sides are on no half stone or bed, that leaves its lintel nothing to lie on,
/// or that meets another one or its lintel.
WallOpenings openings_of(const WallInSpaceParameters&);

}  // namespace voussoir
