// Which edges of quadratic tetrahedra bend: those of one block alone.
//
// What meets at a joint must be the same on both sides, corner by corner: so a face that is or may become a joint has
// straight edges, and so has an edge at which blocks touch without a face. Then contact points that stick tie all of
// what two blocks do there, and quadratic cells are as conforming across joints as linear ones.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"

namespace voussoir {

/// Sets `curved` of all blocks: edges of their tetrahedra that no hexahedron and no other block has. A face that two
/// blocks share has the same cells on both sides.
void find_curved_edges(std::vector<Block<3>>&);

/// Of the curved edges of a block those that lie in none of some facets, such as those that are held: a face that is
/// held at its corners is held between them too.
std::vector<std::array<int, 2>> curved_edges_off(const Block<3>&, const std::function<bool(const TaggedFacet&)>&);

}  // namespace voussoir
