#include "mesh/mesh_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

void add_cells(ParameterSection& section, CellType& cells) {
  section.add_choice<CellType>("cells", cells,
                               {{"triangle", CellType::triangle}, {"quadrilateral", CellType::quadrilateral}},
                               "shape of the cells a block is divided into, P1 triangles or Q1 quadrilaterals");
}

constexpr double foot = 0.3048;  // [m] the international foot, exactly

std::string in_metres(double length) { return number_text(length) + " [m]"; }

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
  add_cells(section, cells);
  section.add_numbers(
      "geometry", geometry, "", any_number(),
      "further numbers set in the .geo by their name, such as pier_settlement = 0.05, in the units of the file");
}

void Opening::declare(ParameterSection& section) {
  section.add("x from", x_from, "m", any_number(), "left side, from the left end of the wall");
  section.add("x to", x_to, "m", any_number(), "right side");
  section.add("y from", y_from, "m", any_number(), "lower side, from the base of the wall");
  section.add("y to", y_to, "m", any_number(), "upper side");
  section.check(x_to > x_from, "x to", in_metres(x_to),
                "must be > x from = " + number_text(x_from) + " (an opening needs an area)",
                "Give the lower left corner by \"x from\", \"y from\"");
  section.check(y_to > y_from, "y to", in_metres(y_to),
                "must be > y from = " + number_text(y_from) + " (an opening needs an area)",
                "Give the lower left corner by \"x from\", \"y from\"");
}

void WallParameters::declare(ParameterSection& section) {
  const std::string whole_block = "a full block of the bond";
  section.add("courses", courses, "-", between(1, 1e6), "courses from base to top", "a wall needs one",
              "Two courses make the smallest bond.");
  section.add("blocks per course", blocks_per_course, "-", between(1, 1e6), "full blocks of courses 0, 2, ...",
              "a course needs one", "Courses 1, 3, ... begin and end with half a block.");
  section.add("block length", block_length, "m", above(0.0), "length of " + whole_block, "a length");
  section.add("block height", block_height, "m", above(0.0), "height of a course", "a length");
  section.add("cells along", cells_along, "-", between(2, 1e4).even(), "cells along a full block",
              "half blocks have half of them", "Give 2, 4, 6, ...");
  section.add("cells up", cells_up, "-", between(1, 1e4), "cells over the height of a block", "a block needs one");
  add_cells(section, cells);

  Family family{"openings", "rectangular openings; blocks whose centre lies inside are left out", "door", {}, {}};
  for (const auto& opening : openings) family.names.push_back(opening.first);
  family.declare = [&](const std::string& name) {
    Opening& o = openings[name];
    o.declare(section);
    const double length = blocks_per_course * block_length, height = courses * block_height;
    section.check(o.x_from < length && o.x_to > 0, "x from", number_text(o.x_from) + " to " + in_metres(o.x_to),
                  "must meet the wall, which reaches from 0 to " + number_text(length) + " m",
                  "Move the opening into the wall or remove it");
    section.check(o.y_from < height && o.y_to > 0, "y from", number_text(o.y_from) + " to " + in_metres(o.y_to),
                  "must meet the wall, which reaches from 0 to " + number_text(height) + " m",
                  "Move the opening into the wall or remove it");
  };
  section.add_family(family);
}

void ArchParameters::declare(ParameterSection& section) {
  section.add("radius", radius, "m", above(0.0), "radius of the middle line", "a length");
  section.add("thickness", thickness, "m", above(0.0), "radial thickness of the ring", "a length");
  section.check(thickness < 2 * radius, "thickness", in_metres(thickness),
                "must be < 2 x radius = " + number_text(2 * radius) + " (the intrados needs a radius)",
                "The radius is that of the middle line; bridges have a thickness of 0.05 to 0.3 radii");
  section.add("embrace", embrace, "degree", inside(0.0, 360.0), "angle between the springings",
              "a closed ring has no springings", "A semicircle has 180.");
  section.add("voussoirs", voussoirs, "-", between(1, 1e6), "blocks of the ring, all alike", "an arch needs one");
  section.add("cells radial", cells_radial, "-", between(1, 1e4), "cells from intrados to extrados",
              "a block needs one");
  section.add("cells along", cells_along, "-", between(1, 1e4), "cells of a voussoir along the ring",
              "a block needs one");
  add_cells(section, cells);
  section.add("pier height", pier_height, "m", at_least(0.0), "height of the piers below the springings; 0 = none",
              "a length", "Give 0 for an arch without piers.");
  section.check(
      pier_height == 0 || embrace == 180, "pier height", in_metres(pier_height),
      "needs an embrace of 180 degrees, not " + number_text(embrace) + " (vertical piers continue a semicircle)",
      "Give embrace 180 or pier height 0");
  section.add("pier courses", pier_courses, "-", between(1, 1e6), "blocks a pier is made of", "a pier needs one");
}

const MasonryParameters* MeshParameters::masonry() const {
  switch (type) {
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
      "Stones in space from a file that holds their surfaces; where they touch there are joints. Sets of blocks: the "
      "name of every stone (object or group of the file); one neighbour: those that touch one other; supports: those "
      "that a file of COMPAS says are held. Sets of facets: base and top: free faces that look down or up, of the "
      "lowest and "
      "the highest stones; faces: all of every stone, by which with blocks = a set of stones those stones are held "
      "whole");
}

}  // namespace voussoir
