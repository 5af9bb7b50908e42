// Structures that need no file: walls and arches in the plane; walls, prisms, domes and barrel vaults in space.
//
// Nodes lie on a lattice; the vertex of a node and its position both follow from
// its lattice indices alone, so coincident nodes of two blocks have equal vertices
// and bitwise equal coordinates, and any rank can build any block by itself.
#pragma once

#include <memory>

#include "mesh/mesh.hpp"
#include "mesh/mesh_parameters.hpp"

namespace voussoir {

/// A wall with its lower left corner at the origin. Blocks are numbered course by course from
/// below, each course from left to right; blocks left out for openings leave no gap in the numbers.
/// Throws InputError when the parameters describe no wall.
std::unique_ptr<BlockSource<2>> make_wall(const WallParameters&);

/// An arch with its centre of curvature at the origin: voussoirs 0, 1, ... counter-clockwise from the right
/// springing (x > 0), then the blocks of the right pier from its foot upward, then those of the left pier.
/// Piers stand on y = -pier_height. Throws InputError when the parameters describe no arch.
std::unique_ptr<BlockSource<2>> make_arch(const ArchParameters&);

/// A wall in space with its lower left front corner at the origin. Blocks are numbered course by course from below,
/// each course along x, then those of its left and its right return outward; those of the ground, if there is one, come
/// first. Throws InputError when the parameters describe no wall.
std::unique_ptr<BlockSource<3>> make_wall_in_space(const WallInSpaceParameters&);

/// A stack of boxes with its lower left front corner at the origin, numbered from below; the ground comes first.
std::unique_ptr<BlockSource<3>> make_prism(const PrismParameters&);

/// A dome with its centre at the origin. Blocks are numbered course by course from the springing, counter-clockwise
/// from x; those of the ground come first. Throws InputError when the parameters describe no dome.
std::unique_ptr<BlockSource<3>> make_dome(const DomeParameters&);

/// A barrel vault with the centre of its front at the origin. Blocks are numbered course by course from the right
/// springing (x > 0), each course along y; those of the right ground come first, of the left ground last.
/// Throws InputError when the parameters describe no vault.
std::unique_ptr<BlockSource<3>> make_barrel_vault(const BarrelVaultParameters&);

}  // namespace voussoir
