// Triangles on the cells of an imprint, and tetrahedra in stones. A cell that two stones have is meshed once, so their
// meshes match node by node.
#pragma once

#include <vector>

#include "mesh/block_list.hpp"
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
Skins skins_of(const StoneStructure&, const std::vector<char>& wanted, const PieceMesher&);

/// How good the cells of the stones are, and how well they fill them.
struct StoneMeshQuality {
  double least_dihedral = 180;  ///< [degree]
  int flat = 0;                 ///< cells with a dihedral angle below 5 degrees
  std::size_t nodes = 0, cells = 0;
  int of_hexahedra = 0;  ///< stones
  int filled = 0;        ///< surfaces that gmsh has filled: stones that are translates of each other have one
  double volume = 0;     ///< [m3] of all stones
};

struct StoneMeshes {
  BlockList<3> list;
  StoneMeshQuality quality;
};

/// Every stone becomes a block, in the order of the stones: of hexahedra where box_mesh.hpp says so, else of tetrahedra
/// (cells of 4 nodes, the first three counter-clockwise seen from the fourth). Sets of blocks: the names of stones,
/// "supports" (where the file has flags), "one neighbour". Sets of facets: "base", "top": free faces that look down or
/// up, of stones whose lowest or highest point is within a hundredth of the height of all from it; "faces": all.
/// Stones whose surfaces are translates of each other but for round-off are filled once.
/// Throws InputError for stones that cannot be filled, naming them.
StoneMeshes mesh_stones(const StoneStructure&, const PieceMesher& = {});

}  // namespace voussoir
