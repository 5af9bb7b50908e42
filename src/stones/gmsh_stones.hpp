// What gmsh does for stones: triangles in plane polygons, tetrahedra in closed surfaces. Each piece alone, so that one
// that fails can be named and the others stand.
#pragma once

#include <string>
#include <vector>

#include "stones/polygon.hpp"
#include "stones/surface.hpp"

namespace voussoir {

using Triangle = std::array<int, 3>;
using Tetrahedron = std::array<int, 4>;

/// A plane polygon with holes, to be cut into triangles with exactly its corners on the border.
struct FlatDomain {
  std::vector<Polygon> loops;  ///< the outer one first
  double size = 0;             ///< [m] wanted length of edges inside
};

/// Nodes are the corners of all loops in their order, then those inside.
struct FlatMesh {
  Polygon inside;
  std::vector<Triangle> triangles;  ///< counter-clockwise
  std::string failure;              ///< empty, or why there is no mesh
};

/// A closed surface of triangles, to be filled with tetrahedra that keep it.
struct ClosedMesh {
  Places nodes;
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
  double size = 0;                  ///< [m]
};

/// Nodes are those of the surface, then those inside.
struct FilledMesh {
  Places inside;
  std::vector<Tetrahedron> cells;  ///< of positive volume
  std::string failure;
};

/// Both are work of gmsh's program (mesh/gmsh_program.hpp); where gmsh crashes on a piece, that piece fails alone.
std::vector<FlatMesh> meshed(const std::vector<FlatDomain>&);
std::vector<FilledMesh> filled(const std::vector<ClosedMesh>&);

}  // namespace voussoir
