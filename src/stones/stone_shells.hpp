// Stones before they are filled: their surfaces in triangles, and all that is known of them as blocks but cells inside.
// The first rank makes them of a file; the ranks that read blocks fill those of their spans (filled_stones.hpp).
#pragma once

#include <Teuchos_Comm.hpp>
#include <vector>

#include "mesh/block_list.hpp"
#include "stones/gmsh_ranks.hpp"
#include "stones/stone_structure.hpp"

namespace voussoir {

/// A surface that one or more stones have, but for where they stand.
struct ShellShape {
  ClosedMesh surface;      ///< of the first stone that has it
  bool is_shared = false;  ///< with other stones, on this rank or another
};

struct StoneShells {
  /// Blocks with cells, or with the nodes, vertices, facets and folds of their surface and no cells. Their sets, their
  /// names, and what is told of all.
  BlockList<3> list;
  std::vector<int> shape;               ///< per block which shape it is to be filled as; -1 where it has cells
  std::vector<std::vector<int>> order;  ///< per block: per node of that shape's surface its own
  std::vector<ShellShape> shapes;
  long long stones = 0;                      ///< on all ranks
  int shapes_to_fill = 0, whole_shapes = 0;  ///< on all ranks: of stones without cells, and of those with
  VertexId vertices = 0;        ///< those that blocks have until now; those inside are numbered behind them
  double largest = 0;           ///< [m] coordinate of all nodes
  bool are_meshed_here = true;  ///< not as the file has them
};

/// Shells of all stones, in the order of the stones: those of hexahedra where box_mesh.hpp says so are blocks already.
/// Sets of blocks: the names of stones, "supports" (where the file has flags), "one neighbour". Sets of facets: "base",
/// "top": free faces that look down or up, of stones whose lowest or highest point is within a hundredth of the height
/// of all from it; "faces": all. Stones whose surfaces are translates of each other but for round-off have one shape.
StoneShells shells_of(const StoneStructure&, const PolygonMesher& = meshed);

/// Blocks that are whole as shells of which none is to be filled.
StoneShells shells_of(BlockList<3> list);

/// Makes blocks that have cells and are alike equal to the last bit (mesh/alike_blocks.hpp), and counts their shapes.
void make_alike_equal(StoneShells&);

/// Hands shells of the first rank out to the readers of their blocks (mesh/read_blocks.hpp), each with the shapes that
/// they have. Collective.
/// @param of_first  of the other ranks nothing is taken
StoneShells handed_out(StoneShells of_first, const Teuchos::Comm<int>&);

}  // namespace voussoir
