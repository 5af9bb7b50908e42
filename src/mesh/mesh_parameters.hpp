// Where the blocks come from: a file or a generator.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/masonry_parameters.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

/// How a block is divided; P1 triangles or Q1 quadrilaterals.
enum class CellType { triangle, quadrilateral };

struct GmshParameters {
  std::string file;           ///< .geo or .msh (format 4.1); a scene that was read holds an absolute path
  double unit = 1.0;          ///< [m] length that the file calls 1
  double element_size = 0.0;  ///< [m] the number `element_size` of the .geo or gmsh's mesh size; 0 = the file's own
  CellType cells = CellType::triangle;     ///< quadrilateral: passed to the .geo as `recombine` = 1
  std::map<std::string, double> geometry;  ///< further numbers set in the .geo, by name, in its units
  void declare(ParameterSection&);
};

/// A rectangular opening in a wall [m]; blocks that lie inside are left out.
struct Opening {
  double x_from = 0, x_to = 0, y_from = 0, y_to = 0;
  void declare(ParameterSection&);
};

/// Running bond: even courses (0, 2, ...) of full blocks, odd ones begin and end with half blocks.
/// Block sets: "course 0", ...; facet sets: "base", "top", "left", "right".
struct WallParameters {
  int courses = 8;
  int blocks_per_course = 8;
  double block_length = 0.5;   ///< [m]
  double block_height = 0.25;  ///< [m]
  int cells_along = 4;         ///< cells along a full block, even (a half block has half of them)
  int cells_up = 2;
  CellType cells = CellType::quadrilateral;
  std::map<std::string, Opening> openings;
  void declare(ParameterSection&);
};

/// Circular arch of equal voussoirs numbered from the right springing, on optional piers.
/// Block sets: "ring", "pier left", "pier right"; facet sets: "springing left", "springing right"
/// (the lowest faces: of the ring, or of the piers where there are any), "extrados", "intrados".
struct ArchParameters {
  double radius = 5.0;     ///< [m] of the middle line
  double thickness = 1.0;  ///< [m] radial
  double embrace = 180.0;  ///< [degree]
  int voussoirs = 31;
  int cells_radial = 4;
  int cells_along = 2;  ///< circumferential cells of a voussoir
  CellType cells = CellType::quadrilateral;
  double pier_height = 0.0;  ///< [m] 0 = no piers (stilts); only with an embrace of 180 degrees
  int pier_courses = 4;      ///< blocks a pier is made of
  void declare(ParameterSection&);
};

enum class MeshType { gmsh, wall, arch, wall_in_space, prism, dome, barrel_vault, stones };

struct MeshParameters {
  MeshType type = MeshType::gmsh;
  GmshParameters gmsh;
  WallParameters wall;
  ArchParameters arch;
  WallInSpaceParameters wall_in_space;
  PrismParameters prism;
  DomeParameters dome;
  BarrelVaultParameters barrel_vault;
  StonesParameters stones;
  /// The generator in space, or none.
  const MasonryParameters* masonry() const;
  MasonryParameters* masonry() { return const_cast<MasonryParameters*>(std::as_const(*this).masonry()); }
  /// The word of a scene for its type.
  std::string word() const;
  /// Of its blocks: 2 in the plane, 3 in space.
  int dimension() const { return type == MeshType::gmsh || type == MeshType::wall || type == MeshType::arch ? 2 : 3; }
  /// Whether they are read from a file, which says what it likes.
  bool from_file() const { return type == MeshType::gmsh || type == MeshType::stones; }
  void declare(ParameterSection&);
};

}  // namespace voussoir
