// What is told of stones that do not fit together: where, and of which.
#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/text.hpp"
#include "stones/imprint.hpp"

namespace voussoir {
namespace {

/// [m] between two planes along the normal of a facet that hold all of a stone; of all facets the least.
double thickness_of(const FacetedStone& stone) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& facet : stone.facets) {
    double deepest = 0;
    for (const auto& x : stone.surface->points) deepest = std::max(deepest, dot(facet.centre - x, facet.normal));
    least = std::min(least, deepest);
  }
  return least;
}

/// Of stones whose opposite faces have become one, a line each.
std::string thin_stones(const std::vector<FacetedStone>& stones, double weld) {
  std::string lines;
  int told = 0;
  for (const auto& stone : stones) {
    const double thickness = thickness_of(stone);
    if (thickness <= weld && ++told <= 5)
      lines += "\n    " + in_words(*stone.surface) + " is " + six_digits(thickness) +
               " m thick, thinner than weld, which makes its opposite faces one";
  }
  return lines;
}

}  // namespace

void refuse_faults(const Imprint& imprint, const std::vector<FacetedStone>& stones, double tolerance, double weld) {
  const auto& faults = imprint.faults;
  if (faults.none()) return;
  std::string message = "mesh > stones: with joint tolerance = " + number_text(tolerance) +
                        " [m] and weld = " + number_text(weld) +
                        " [m] the stones do not fit together:" + thin_stones(stones, weld);
  const auto add = [&](std::size_t number, const std::string& what, int stone, const Vector<3>& place) {
    message += "\n    " + std::to_string(number) + " " + what + ", first of " + in_words(*stones[stone].surface) +
               " at " + place_in_words(place);
  };
  const auto add_cells = [&](const std::vector<int>& cells, const std::string& what) {
    if (cells.empty()) return;
    const auto& cell = imprint.cells[cells[0]];
    add(cells.size(), what, cell.stone, imprint.points[cell.outer[0]]);
  };
  if (!faults.open_stones.empty())
    add(faults.open_stones.size(), "stones whose cut facets are not closed", faults.open_stones[0][0],
        imprint.points[faults.open_stones[0][1]]);
  add_cells(faults.lonely, "joint faces that the other stone has not");
  add_cells(faults.crowded, "faces that more than two stones have");
  if (!faults.crossings.empty()) {
    const auto [stone, facet] = faults.crossings[0];
    add(faults.crossings.size(), "joints that cross on a face", stone, stones[stone].facets[facet].centre);
  }
  throw InputError(message +
                   "\n  Raise joint tolerance above the largest gap in a joint and weld to two to ten times of it, or "
                   "lower\n  both below the thinnest part of a stone and the narrowest gap that is meant to be open.");
}

}  // namespace voussoir
