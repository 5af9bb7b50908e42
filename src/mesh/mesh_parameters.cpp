#include "mesh/mesh_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

constexpr double foot = 0.3048;  // [m] the international foot, exactly

std::vector<std::pair<std::string, MeshType>> mesh_types() {
  return {{"gmsh", MeshType::gmsh},
          {"wall", MeshType::wall},
          {"arch", MeshType::arch},
          {"wall in space", MeshType::wall_in_space},
          {"prism", MeshType::prism},
          {"dome", MeshType::dome},
          {"barrel vault", MeshType::barrel_vault},
          {"stones", MeshType::stones}};
}

}  // namespace

void GmshParameters::declare(ParameterSection& section) {
  section.add("file", file,
              "geometry (.geo) or mesh (.msh, format 4.1); a relative path is sought beside the scene, then in its "
              "parent folder and the folder meshes/ of that",
              Presence::required, "Give the path of a file of gmsh, such as meshes/clare-college-bridge.geo.");
  section.add_choice<double>("unit", unit, {{"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"ft", foot}},
                             "unit of the lengths in the file; everything else of a scene is in metres");
  section.add(
      "element size", element_size, "m", at_least(0.0).usually(1e-4, 10),
      "wanted length of cell edges: the number element_size where the .geo defines one, else gmsh's mesh size; 0 "
      "keeps that of the file",
      "a length", "Give 0 for the size the file has.");
  declare_cell_type(section, cells);
  section.add_numbers(
      "geometry", geometry, "", any_number(),
      "further numbers set in the .geo by their name, such as pier_settlement = 0.05, in the units of the file");
}

bool MeshParameters::has_quadratic_triangles() const {
  return (type == MeshType::gmsh && gmsh.cells == CellType::quadratic_triangle) ||
         (type == MeshType::wall && wall.cells == CellType::quadratic_triangle) ||
         (type == MeshType::arch && arch.cells == CellType::quadratic_triangle) ||
         (type == MeshType::stones && stones.cells == StoneCells::quadratic_triangles);
}

const MasonryParameters* MeshParameters::masonry() const {
  switch (type) {
    case MeshType::wall:
      return &wall;
    case MeshType::arch:
      return &arch;
    case MeshType::wall_in_space:
      return &wall_in_space;
    case MeshType::prism:
      return &prism;
    case MeshType::dome:
      return &dome;
    case MeshType::barrel_vault:
      return &barrel_vault;
    default:
      return nullptr;
  }
}

std::string MeshParameters::word() const {
  for (const auto& [word, meaning] : mesh_types())
    if (meaning == type) return word;
  return "";
}

void MeshParameters::declare(ParameterSection& section) {
  section.add_choice<MeshType>("type", type, mesh_types(),
                               "where the blocks come from; only the sublist of that name may be present",
                               Presence::required);
  section.add_alternative("gmsh", gmsh, type == MeshType::gmsh, "type = gmsh",
                          "Blocks drawn with gmsh: every plane surface is a block; its physical groups name the sets");
  section.add_alternative("wall", wall, type == MeshType::wall, "type = wall",
                          "Wall in running bond, lower left corner at the origin. Sets of blocks: course 0, course 1, "
                          "...; sets of facets: base, top, left, right");
  section.add_alternative("arch", arch, type == MeshType::arch, "type = arch",
                          "Circular arch, centre of curvature at the origin, voussoirs numbered from the right "
                          "springing. Sets of blocks: ring, pier left, pier right; sets of facets: springing left, "
                          "springing right, extrados, intrados");
  section.add_alternative(
      "wall in space", wall_in_space, type == MeshType::wall_in_space, "type = wall in space",
      "Wall of hexahedra, one block thick, with returns and openings: x along it from its left end, y through it from "
      "its front, z up from its base. Sets of blocks: course 0, course 1, ...; ground, facade, return left, return "
      "right, lintels where there are such. Sets of facets: base, top, left, right, front, back; return left inside, "
      "return right inside and return ends; ground: the outer faces and the upper one of the ground, which held there "
      "does not move");
  section.add_alternative("prism", prism, type == MeshType::prism, "type = prism",
                          "Stack of boxes of hexahedra: x along, y across, z up, lower left front corner at the "
                          "origin. Sets of blocks: course 0, ..., ground; sets of facets: base, top, left, right, "
                          "front, back, ground");
  section.add_alternative(
      "dome", dome, type == MeshType::dome, "type = dome",
      "Dome of hexahedra about the z axis with its centre at the origin, courses numbered from the springing upward. "
      "Sets of blocks: course 0, course 1, ..., ground; sets of facets: base, oculus, intrados, extrados, ground");
  section.add_alternative(
      "barrel vault", barrel_vault, type == MeshType::barrel_vault, "type = barrel vault",
      "Barrel vault of hexahedra: the arch of the plane x, z, with its centre at the origin, drawn out along y. "
      "Courses "
      "lie along y and are numbered from the right springing (x > 0). Sets of blocks: course 0, course 1, ...; ground "
      "left, ground right where there is ground. Sets of facets: springing left, springing right, intrados, extrados, "
      "front (y = 0), back; ground left, ground right");
  section.add_alternative(
      "stones", stones, type == MeshType::stones, "type = stones",
      "Stones from a file that holds their surfaces or, in the plane, their outlines; where they touch there are "
      "joints. "
      "Sets of blocks: the "
      "name of every stone (object or group of the file); one neighbour: those that touch one other; supports: those "
      "that a file of COMPAS says are held; of a drawing: names of stones, and its layers or classes. Sets of facets: "
      "base and top: free faces that look down or up, of the "
      "lowest and "
      "the highest stones (of a drawing left and right too); faces: all of every stone, by which with blocks = a set "
      "of stones those stones are held "
      "whole");
}

}  // namespace voussoir
