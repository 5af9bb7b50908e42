// Facets cut by their joints: the surfaces of all stones over one set of points, so that where two stones touch they
// have the same cell, and their meshes can be the same.
//
// Every facet becomes a plane drawing of its border and of the joint polygons on it, over points that are one when they
// are closer than the weld distance, with every edge cut at all points that lie on it. Because the cuts are those of
// the points, not of the facet, neighbouring facets and neighbouring stones cut their common edges alike.
#pragma once

#include "base/warning.hpp"
#include "stones/stone_joints.hpp"

namespace voussoir {

/// A part of a facet that touches one other stone, or none.
struct ImprintedCell {
  int stone = 0, facet = 0, joint = -1;  ///< joint: into StoneJoints::joints, -1 = none
  std::vector<int> outer;                ///< numbers of points, counter-clockwise from outside
  std::vector<std::vector<int>> holes;   ///< clockwise from outside
  double area = 0;                       ///< [m2]
};

/// What must not be: the meshes of two stones would not match, or a stone would leak.
struct ImprintFaults {
  std::vector<std::array<int, 2>> open_stones;  ///< whose cells are not closed, with a point where
  std::vector<int> lonely;                      ///< cells of a joint whose other stone has no such cell
  std::vector<int> crowded;                     ///< cells that three stones have
  std::vector<std::array<int, 2>> crossings;    ///< stone and facet with edges that cross
  bool none() const { return open_stones.empty() && lonely.empty() && crowded.empty() && crossings.empty(); }
};

struct Imprint {
  Places points;
  std::vector<std::vector<int>>
      number;                        ///< per stone and point of its surface: what it has become, or -1 inside facets
  std::vector<ImprintedCell> cells;  ///< in the order of stones and facets
  std::vector<int> other;            ///< per cell the cell of another stone with the same border, or -1
  ImprintFaults faults;
  double shortest_edge = 0;  ///< [m]
};

/// @param weld  [m] points closer than this are one; at least the distance of points that two stones mean to share
Imprint imprinted(const std::vector<FacetedStone>&, const StoneJoints&, double weld);

/// The joints that welding has made: faces of two stones that lie farther apart than joints do, and whose corners have
/// become one. They are one place from here on, so they are told and treated as the joints they are; their pieces are
/// empty, as no facet is cut by them.
/// @param first  the number of the first of them; their cells are given it and those that follow
std::vector<StoneJoint> welded_joints(Imprint&, const std::vector<FacetedStone>&, int first);

/// Throws InputError where the imprint has faults, with the first places and what to do.
void refuse_faults(const Imprint&, const std::vector<FacetedStone>&, double tolerance, double weld);

}  // namespace voussoir
