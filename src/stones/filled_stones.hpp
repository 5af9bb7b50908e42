// Tetrahedra in the surfaces of stones, by the ranks that read them.
#pragma once

#include <Teuchos_Comm.hpp>
#include <functional>
#include <vector>

#include "mesh/block_list.hpp"
#include "stones/gmsh_stones.hpp"
#include "stones/stone_shells.hpp"

namespace voussoir {

/// How good the cells of the stones are, and how well they fill them.
struct StoneMeshQuality {
  double least_dihedral = 180;  ///< [degree]
  int flat = 0;                 ///< cells with a dihedral angle below 5 degrees
  long long nodes = 0, cells = 0;
  int of_hexahedra = 0;  ///< stones
  int filled = 0;        ///< surfaces that are filled: stones that are translates of each other have one
  double volume = 0;     ///< [m3] of all stones
};

struct StoneMeshes {
  BlockList<3> list;         ///< of the span that this rank reads
  StoneMeshQuality quality;  ///< of all ranks
};

using SurfaceFiller = std::function<std::vector<FilledMesh>(const std::vector<ClosedMesh>&)>;

/// Fills shells with tetrahedra (cells of 4 nodes, the first three counter-clockwise seen from the fourth). gmsh makes
/// the same of a surface whoever asks it, and nodes inside are numbered stone by stone, so nothing depends on ranks.
/// Throws InputError for stones that cannot be filled, naming them, on every rank. Collective.
/// @param shells  of this rank
StoneMeshes filled_stones(StoneShells shells, const Teuchos::Comm<int>&, const SurfaceFiller& = filled);

/// All stones as blocks, where one rank has all of them.
StoneMeshes mesh_stones(const StoneStructure&);

}  // namespace voussoir
