// All that is known of the stones of a drawing before they are meshed, and what a user is told of it.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "drawings/snapped.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

struct PlaneStones {
  std::vector<OutlinedStone> stones;  ///< [m] y up
  SnappedStones snapped;
  double snap = 0, element_size = 0;  ///< [m]
  std::vector<std::string> report;    ///< lines of what was found
  Warnings warnings;
};

/// Of the median size of stones (the square root of an area): the length of cells that is chosen.
constexpr double usual_element = 0.25;

/// Reads the drawing and fits its stones together. Throws InputError for files that cannot be read, outlines that are
/// none, and stones that do not fit together.
PlaneStones plane_stones_of(const StonesParameters&);

/// The same of a drawing that is there already.
PlaneStones plane_stones_of(DrawnFile, const StonesParameters&);

/// Outlines as drawn and as they are computed with, where corners moved, and the names of stones, as SVG.
std::string picture_of(const PlaneStones&);

}  // namespace voussoir
