// Where the blocks come from: a file or a generator.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/masonry_parameters.hpp"
#include "stones/stones_parameters.hpp"

namespace voussoir {

struct GmshParameters {
  std::string file;           ///< .geo or .msh (format 4.1); a scene that was read holds an absolute path
  double unit = 1.0;          ///< [m] length that the file calls 1
  double element_size = 0.0;  ///< [m] the number `element_size` of the .geo or gmsh's mesh size; 0 = the file's own
  CellType cells = CellType::triangle;     ///< quadrilaterals: passed to the .geo as `recombine` = 1
  std::map<std::string, double> geometry;  ///< further numbers set in the .geo, by name, in its units
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
  /// The generator, or none.
  const MasonryParameters* masonry() const;
  MasonryParameters* masonry() { return const_cast<MasonryParameters*>(std::as_const(*this).masonry()); }
  /// The word of a scene for its type.
  std::string word() const;
  /// Of its blocks: 2 in the plane, 3 in space.
  int dimension() const {
    if (type == MeshType::stones) return stones.is_drawing() ? 2 : 3;
    return type == MeshType::gmsh || type == MeshType::wall || type == MeshType::arch ? 2 : 3;
  }
  /// Whether they are read from a file, which says what it likes.
  bool from_file() const { return type == MeshType::gmsh || type == MeshType::stones; }
  /// Whether triangles of the plane bend along their edges.
  bool has_quadratic_triangles() const;
  void declare(ParameterSection&);
};

}  // namespace voussoir
