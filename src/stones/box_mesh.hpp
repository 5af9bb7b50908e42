// Hexahedra in stones that are boxes, where all stones they touch, directly or through others, are boxes too and joints
// cut their faces along lattice lines: faces of hexahedra match faces of hexahedra alone.
//
// A cut of a face goes through the whole stone, and through the joints to its neighbours, so in a bond without order
// the lattice of each stone would have the cuts of all. Such stones are left to tetrahedra.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "stones/stone_structure.hpp"

namespace voussoir {

/// Per stone a block of hexahedra, or one without cells where there is none. Vertices are numbered from 0, equal where
/// stones touch.
struct BoxMeshes {
  std::vector<Block<3>> blocks;
  std::vector<std::vector<TaggedFacet>> free_faces;  ///< per stone those no other has; `set` is the facet they lie on
  VertexId vertices = 0;
};

/// Where the lattices turn out not to match joint for joint there are no hexahedra at all.
BoxMeshes box_meshes(const StoneStructure&);

/// [m3] inside the cells of a block of hexahedra; not a number where one is turned inside out at a corner.
double volume_of_hexahedra(const Block<3>&);

}  // namespace voussoir
