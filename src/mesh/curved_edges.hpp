// Which edges of quadratic triangles and tetrahedra bend: those of one block alone.
//
// What meets at a joint must be the same on both sides, corner by corner: so a face that is or may become a joint has
// straight edges, and so has an edge at which blocks touch without a face. Then contact points that stick tie all of
// what two blocks do there, and quadratic cells are as conforming across joints as linear ones.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// Sets `curved` of all blocks: edges of their triangles or tetrahedra that no other cell of theirs and no other block
/// has. A face that two blocks share has the same cells on both sides.
template <int dim>
void find_curved_edges(std::vector<Block<dim>>&);

/// The blocks of a source with the edges that are curved; each is made of what the source gives of it and of the blocks
/// that touch it.
template <int dim>
std::unique_ptr<BlockSource<dim>> with_curved_edges(std::unique_ptr<BlockSource<dim>>);

/// Of the curved edges of a block those that lie in none of some facets, such as those that are held: a face that is
/// held at its corners is held between them too.
template <int dim>
std::vector<std::array<int, 2>> curved_edges_off(const Block<dim>&, const std::function<bool(const TaggedFacet&)>&);

}  // namespace voussoir
