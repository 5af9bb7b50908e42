// A plane mesh cut into surfaces, as mesh files have it, and how it becomes blocks.
#pragma once

#include "mesh/block_list.hpp"

namespace voussoir {

/// Surfaces over one common list of nodes. Neighbouring surfaces share nodes, or have nodes of their own
/// at the same places when they were meshed apart.
struct SurfaceMesh {
  struct Surface {
    int tag = 0;
    std::vector<int> sets;    ///< into block_sets, ascending
    std::vector<Cell> cells;  ///< of node numbers
  };
  /// An edge of a named set.
  struct Line {
    std::array<int, 2> node{};
    int set = 0;  ///< into facet_sets
  };
  std::vector<Vector<2>> position;  ///< [m] per node
  std::vector<Surface> surfaces;    ///< in the order of the blocks
  std::vector<Line> lines;
  std::vector<int> corners;  ///< nodes at points of the drawing, where what is drawn may turn
  std::vector<std::string> block_sets;
  std::vector<std::string> facet_sets;
};

/// The mesh as bytes, for another process of this program, and back. Throws InputError for bytes that are no mesh.
std::string bytes_of(const SurfaceMesh&);
SurfaceMesh surface_mesh_of(const std::string& bytes);

/// Coincident nodes of different surfaces are the same vertex when they are closer than this part of
/// the shortest edge at either node: far above the rounding of coordinates in files (1e-16 relative in double,
/// 1e-9 as text), far below any joint somebody could have drawn open.
constexpr double coincidence = 1e-6;
/// And than this part of their distance from the origin: gmsh divides curves to 5e-13 of the coordinates of their ends
/// (3e-6 m at 1e7 m, by differences of places), so equal divisions of two coincident curves lie so far apart; but never
/// farther than a thousandth of that edge, a tenth of what is taken for a joint that does not match.
constexpr double coincidence_far = 2e-12, farthest_coincidence = 1e-3;

/// Vertex of each node: compact numbers in the order of nodes. Nodes of one surface are never united,
/// so that a slit inside a stone stays a slit.
std::vector<VertexId> vertices_of_nodes(const SurfaceMesh&);

/// Every surface becomes a block with its own copies of the nodes, named "surface 17 (ring west)". Surfaces that are
/// numbered clockwise as a whole are turned over. A line belongs to every block on whose border it lies.
/// Throws InputError for a set of lines that lie on the border of no block.
BlockList<2> blocks_of_surfaces(const SurfaceMesh&);

}  // namespace voussoir
