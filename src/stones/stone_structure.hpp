// All that is known of the stones of a file before they are meshed, and what a user is told of it.
#pragma once

#include <string>
#include <vector>

#include "base/warning.hpp"
#include "stones/imprint.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

struct StoneStructure {
  std::vector<StoneSurface> stones;   ///< closed, faces outward [m], z up
  std::vector<FacetedStone> faceted;  ///< of `stones`, by address
  StoneJoints joints;                 ///< with those that welding has made
  Imprint imprint;
  double tolerance = 0, weld = 0;                    ///< [m]
  double tetrahedron_size = 0, hexahedron_size = 0;  ///< [m] wanted length of edges
  StoneCells cells = StoneCells::by_shape;
  std::vector<std::string> report;  ///< lines of what was found
  Warnings warnings;

  StoneStructure() = default;
  StoneStructure(StoneStructure&&) = default;
  StoneStructure& operator=(StoneStructure&&) = default;
  StoneStructure(const StoneStructure&) = delete;  // facets know their stones by address
  StoneStructure& operator=(const StoneStructure&) = delete;
};

/// What the numbers of a file of stones rest on.
struct StoneDefaults {
  /// Of the median cube root of volume: joints of files that are exact, and of those rounded to millimetres.
  double tolerance = 2e-3;
  /// Of the tolerance: corners of the two sides of a joint lie farther apart than its planes.
  double weld = 3;
  /// Of the median cube root of volume: hexahedra, and linear tetrahedra (200 corners a stone).
  double element_size = 0.25;
  /// Quadratic tetrahedra: 100 corners a stone, with which a vault bends within 1 % of fine cells (elements.md). The
  /// matrix of a stone grows with the square of its corners.
  double quadratic_size = 0.4;
  /// Of the tolerance: what faces each other so closely was probably meant to touch, with mortar between.
  double reach = 30;
};

/// [m] The joint tolerance of a scene, or the one that is chosen for its stones.
double tolerance_of(const std::vector<StoneSurface>&, const StonesParameters&);
/// Turns places of a file so that its axis that points up is z.
void turn_up(UpAxis, Places&);
/// Throws InputError for stones that lie in each other by more than the tolerance.
void refuse_overlaps(const std::vector<StoneSurface>&, double tolerance);

/// Throws InputError for a stone that is called as a set is that every scene knows.
void refuse_names_of_sets(const std::string& file, const std::vector<StoneSurface>&);

/// Reads the file and finds joints. Throws InputError for files that cannot be read, stones that cannot be mended, that
/// overlap by more than the tolerance or do not fit together.
StoneStructure structure_of(const StonesParameters&);

/// The same of stones that are there already.
StoneStructure structure_of(const std::vector<StoneSurface>& drawn, const StonesParameters&);

}  // namespace voussoir
