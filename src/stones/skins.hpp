// Triangles on the cells of an imprint. A cell that two stones have is meshed once, so their meshes match node by node.
#pragma once

#include <vector>

#include "stones/gmsh_ranks.hpp"
#include "stones/stone_structure.hpp"

namespace voussoir {

/// Triangles on all cells over one set of nodes.
struct Skins {
  Places nodes;                                  ///< [m] those of the imprint, then on edges, then in cells
  std::vector<std::vector<Triangle>> triangles;  ///< per cell of the imprint, counter-clockwise from outside its stone
};

/// Edges are cut into equal parts no longer than the size. Cells are meshed flat, with the nodes of their edges put on
/// the straight edges between the points of the imprint and those inside lifted with them by a discrete harmonic
/// function: welded points need not lie in one plane, and gmsh makes no sense of plane surfaces that are not plane.
/// Cells that are translates of each other but for round-off are meshed once (mesh/translates.hpp), so stones that are
/// alike have triangles that are.
/// Throws InputError for a cell that cannot be meshed.
/// @param wanted  per stone, whether its cells are meshed at all
Skins skins_of(const StoneStructure&, const std::vector<char>& wanted, const PolygonMesher&);

}  // namespace voussoir
