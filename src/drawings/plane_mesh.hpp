// Cells of the stones of a drawing: quadrilaterals where a stone is one, triangles by gmsh elsewhere. An edge is cut
// once for both stones, so that their meshes match node by node.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "drawings/plane_stones.hpp"
#include "mesh/block_list.hpp"

namespace voussoir {

/// In how many parts each edge is cut, and which stones are quadrilaterals.
struct EdgeDivisions {
  std::map<std::pair<int, int>, int> parts;  ///< of each edge, by its points in ascending order
  /// Per stone where its four sides begin in its outline; empty for a stone of triangles.
  std::vector<std::vector<int>> sides;
};

/// Parts no longer than the element size; more where sides of a quadrilateral that lie across want as many. A stone
/// whose side would need more than `most_added` times of what it had is none.
EdgeDivisions divided(const PlaneStones&, StoneCells);

struct PlaneMeshes {
  BlockList<2> list;
  int of_quadrilaterals = 0;  ///< stones
  std::size_t nodes = 0, cells = 0;
};

/// Every stone becomes a block. Sets of blocks: names of stones, and their layers or classes. Sets of facets: "base",
/// "top", "left", "right": free edges that look there (within 45 degrees), of stones that reach within a hundredth of
/// the drawing's size to its end; "faces": all.
/// Throws InputError for stones that cannot be meshed, and for more cells than this machine could compute with.
PlaneMeshes mesh_plane_stones(const PlaneStones&, StoneCells);

}  // namespace voussoir
