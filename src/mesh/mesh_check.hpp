// Is this mesh one that can be computed? If not: which block, where, why, and what to do.
//
// Meant for meshes from files; generated walls and arches are right by construction, but for openings that leave
// blocks without support. Takes O(n log n), a small part of the time it takes to mesh.
#pragma once

#include <Teuchos_Comm.hpp>
#include <string>
#include <vector>

#include "mesh/facet_set.hpp"
#include "mesh/mesh.hpp"

namespace voussoir {

/// Corner angles of a cell below this are refused: 60 (90) degrees is perfect, and the error of the gradient and the
/// condition of the stiffness grow like 1 / sin(angle).
constexpr double smallest_corner_angle = 1.0;  // [degree]

/// Throws InputError for the first of these faults, looked for in this order, of all blocks of a mesh:
/// - one block by itself: no cells, coordinates that are no numbers, nodes without cell, inverted cells, cells with
///   a corner below `smallest_corner_angle` or above 180 degrees less that, cells that lie on each other, several
///   pieces
/// - between blocks: edges of three blocks, blocks on the same side of an edge, borders that touch or nearly touch
///   without matching nodes, blocks that overlap
void check_mesh(const std::vector<Block<2>>&);

/// Throws InputError for blocks that hold no facet of a supported set and are not joined, directly or through others,
/// to one that does. Blocks are joined when they share `dim` vertices. An empty list of sets means that
/// nothing is supported on purpose; then nothing is checked. Each rank looks at the blocks it reads. Collective.
template <int dim>
void check_supports(const BlockSource<dim>&, const std::vector<FacetNames>& supported, const Teuchos::Comm<int>&);

/// The two groups of faults of `check_mesh`.
void check_block(const Block<2>&);
void check_borders(const std::vector<Block<2>>&);

}  // namespace voussoir
