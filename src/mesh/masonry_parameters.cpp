#include "mesh/masonry_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

std::string in_metres(double length) { return number_text(length) + " [m]"; }

void add_bond(ParameterSection& section, WallBond& bond, const std::string& text) {
  section.add_choice<WallBond>("bond", bond, {{"running", WallBond::running}, {"stack", WallBond::stack}}, text);
}

void add_faces(ParameterSection& section, StoneFaces& faces, const std::string& of_bond) {
  section.add_choice<StoneFaces>(
      "faces", faces, {{"round", StoneFaces::round}, {"plane", StoneFaces::plane}},
      "round: corners of all cells lie on round surfaces; plane: faces are stretched between "
      "the corners of stones" +
          of_bond);
}

void add_cells(ParameterSection& section, const std::string& name, int& cells, const std::string& text) {
  section.add(name, cells, "-", between(1, 1e4), text, "a stone needs one");
}

void add_ground(ParameterSection& section, double& height, const std::string& text) {
  section.add("ground height", height, "m", at_least(0.0), text + "; 0 = none", "a length",
              "Give 0 for masonry that is held at its own faces.");
}

/// One direction of an opening.
void add_span(ParameterSection& section, const std::string& axis, double& from, double& to, const std::string& up,
              const std::string& from_text, const std::string& to_text) {
  section.add(axis + " from", from, "m", any_number(), from_text);
  section.add(axis + " to", to, "m", any_number(), to_text);
  section.check(to > from, axis + " to", in_metres(to),
                "must be > " + axis + " from = " + number_text(from) + " (an opening needs an area)",
                "Give the lower left corner by \"x from\", \"" + up + " from\"");
}

/// What a ring, a dome and a vault have.
/// @param middle  "middle line"
/// @param thin    "bridges have a thickness of 0.05 to 0.3 radii"
void add_ring(ParameterSection& section, double& radius, double& thickness, const std::string& middle,
              const std::string& text, const std::string& thin) {
  section.add("radius", radius, "m", above(0.0), "radius of the " + middle, "a length");
  section.add("thickness", thickness, "m", above(0.0), text, "a length");
  section.check(thickness < 2 * radius, "thickness", in_metres(thickness),
                "must be < 2 x radius = " + number_text(2 * radius) + " (the intrados needs a radius)",
                "The radius is that of the " + middle + "; " + thin);
}

void add_embrace(ParameterSection& section, double& embrace) {
  section.add("embrace", embrace, "degree", inside(0.0, 360.0), "angle between the springings",
              "a closed ring has no springings", "A semicircle has 180.");
}

}  // namespace

void declare_cell_type(ParameterSection& section, CellType& cells) {
  section.add_choice<CellType>("cells", cells,
                               {{"triangle", CellType::triangle},
                                {"quadrilateral", CellType::quadrilateral},
                                {"quadratic triangle", CellType::quadratic_triangle}},
                               "cells a block is divided into: P1 triangles, Q1 quadrilaterals, or triangles that bend "
                               "along their edges, but for edges on joints and supports, and are condensed to their "
                               "corners");
}

void Opening::declare(ParameterSection& section) {
  add_span(section, "x", x_from, x_to, "y", "left side, from the left end of the wall", "right side");
  add_span(section, "y", y_from, y_to, "y", "lower side, from the base of the wall", "upper side");
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
  declare_cell_type(section, cells);

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
  add_ring(section, radius, thickness, "middle line", "radial thickness of the ring",
           "bridges have a thickness of 0.05 to 0.3 radii");
  add_embrace(section, embrace);
  section.add("voussoirs", voussoirs, "-", between(1, 1e6), "blocks of the ring, all alike", "an arch needs one");
  section.add("cells radial", cells_radial, "-", between(1, 1e4), "cells from intrados to extrados",
              "a block needs one");
  section.add("cells along", cells_along, "-", between(1, 1e4), "cells of a voussoir along the ring",
              "a block needs one");
  declare_cell_type(section, cells);
  section.add("pier height", pier_height, "m", at_least(0.0), "height of the piers below the springings; 0 = none",
              "a length", "Give 0 for an arch without piers.");
  section.check(
      pier_height == 0 || embrace == 180, "pier height", in_metres(pier_height),
      "needs an embrace of 180 degrees, not " + number_text(embrace) + " (vertical piers continue a semicircle)",
      "Give embrace 180 or pier height 0");
  section.add("pier courses", pier_courses, "-", between(1, 1e6), "blocks a pier is made of", "a pier needs one");
}

void OpeningInSpace::declare(ParameterSection& section) {
  add_span(section, "x", x_from, x_to, "z", "left side, from the left end of the wall; on half a stone",
           "right side; on half a stone");
  add_span(section, "z", z_from, z_to, "z", "lower side, from the base of the wall; on a bed", "upper side; on a bed");
}

void WallInSpaceParameters::declare(ParameterSection& section) {
  section.add("courses", courses, "-", between(1, 1e6), "courses from base to top, without the ground",
              "a wall needs one", "One course of one block is a prism.");
  section.add("blocks per course", blocks_per_course, "-", between(1, 1e6), "full blocks of courses 0, 2, ...",
              "a course needs one", "In running bond courses 1, 3, ... begin and end with half a block.");
  section.add("block length", block_length, "m", above(0.0), "length of a full block, along x", "a length");
  section.add("block height", block_height, "m", above(0.0), "height of a course, along z", "a length");
  section.add("thickness", thickness, "m", above(0.0), "of the wall and its blocks, along y", "a length");
  add_bond(section, bond, "running: half a block from course to course; stack: head joints above each other");
  section.add("cells along", cells_along, "-", between(1, 1e4),
              "cells along a full block; even in running bond and in a wall with openings",
              "half blocks have half of them", "Give 2, 4, 6, ...");
  section.add("cells up", cells_up, "-", between(1, 1e4), "cells over the height of a block", "a block needs one");
  section.add("cells across", cells_across, "-", between(1, 1e4), "cells through the thickness of a block",
              "a block needs one");
  add_ground(section, ground_height,
             "height of a course of full blocks below the wall, on which it stands with a joint");
  const std::string from_face =
      ": full blocks from the outer face of the wall to its end; 0 = none. Returns are bonded "
      "in: even courses have the corner in the wall, odd ones in the return";
  section.add("return left", return_left, "-", between(0, 1e6), "return at the left end" + from_face,
              "a length in blocks", "Give 0 for none.");
  section.add("return right", return_right, "-", between(0, 1e6), "return at the right end, likewise",
              "a length in blocks", "Give 0 for none.");
  section.add_choice<ReturnsTo>("returns to", returns_to, {{"back", ReturnsTo::back}, {"front", ReturnsTo::front}},
                                "back: returns lead to +y, front: to -y");
  Family family{"openings",
                "rectangular openings, each with a lintel in the course above it that lies on half a block at either "
                "side, unless it reaches the top",
                "door",
                {},
                {}};
  for (const auto& opening : openings) family.names.push_back(opening.first);
  family.declare = [&](const std::string& name) { openings[name].declare(section); };
  section.add_family(family);
}

void PrismParameters::declare(ParameterSection& section) {
  section.add("length", length, "m", above(0.0), "along x", "a length");
  section.add("width", width, "m", above(0.0), "along y", "a length");
  section.add("height", height, "m", above(0.0), "of all stones together, along z", "a length");
  section.add("stones", stones, "-", between(1, 1e6), "equal stones on each other", "a prism is one");
  add_cells(section, "cells along", cells_along, "cells of a stone along x");
  add_cells(section, "cells across", cells_across, "cells of a stone along y");
  add_cells(section, "cells up", cells_up, "cells of a stone along z");
  add_ground(section, ground_height, "height of a block below the prism, on which it stands with a joint");
}

void DomeParameters::declare(ParameterSection& section) {
  add_ring(section, radius, thickness, "middle surface", "radial thickness",
           "domes have a thickness of 0.03 to 0.2 radii");
  section.add("oculus", oculus, "degree", inside(0.0, 180.0), "angle from the crown at which the last course ends",
              "stones that meet in the crown would have no upper face", "Give a small angle, such as 5.");
  section.add("springing", springing, "degree", inside(0.0, 180.0), "angle from the crown at which course 0 begins",
              "a whole sphere has no springing", "A half sphere has 90.");
  section.check(oculus < springing, "oculus", number_text(oculus) + " [degree]",
                "must be < springing = " + number_text(springing) + " (the dome reaches from the springing up to it)",
                "Both are measured from the crown");
  section.add("courses", courses, "-", between(1, 1e6), "from springing to oculus, equal in angle", "a dome needs one");
  section.add("lunes", lunes, "-", between(3, 1e6), "stones of a course", "fewer than three go round no axis");
  add_bond(section, bond,
           "running: odd courses are turned by half a stone; stack: head joints above each other, whole lunes part");
  add_faces(section, faces, ", in running bond of half stones");
  add_cells(section, "cells radial", cells_radial, "cells from intrados to extrados");
  add_cells(section, "cells round", cells_round, "cells of a stone along its course; even in running bond");
  add_cells(section, "cells up", cells_up, "cells of a stone along the meridian");
  add_ground(section, ground_height,
             "height of a ring of blocks below the springing, on which the dome stands with a joint");
}

void BarrelVaultParameters::declare(ParameterSection& section) {
  add_ring(section, radius, thickness, "middle surface", "radial thickness",
           "vaults have a thickness of 0.05 to 0.3 radii");
  add_embrace(section, embrace);
  section.add("length", length, "m", above(0.0), "along y", "a length");
  section.add("voussoirs", voussoirs, "-", between(1, 1e6), "courses from springing to springing, all alike",
              "a vault needs one");
  section.add("stones along", stones_along, "-", between(1, 1e6), "full stones of courses 0, 2, ... along y",
              "a course needs one", "In running bond courses 1, 3, ... begin and end with half a stone.");
  add_bond(section, bond, "running: half a stone from course to course; stack: arches beside each other");
  add_faces(section, faces, "");
  add_cells(section, "cells radial", cells_radial, "cells from intrados to extrados");
  add_cells(section, "cells round", cells_round, "cells of a stone from springing to springing");
  add_cells(section, "cells along", cells_along, "cells of a full stone along y; even in running bond");
  add_ground(section, ground_height, "height of blocks beyond the springings, on which the vault stands with joints");
}

}  // namespace voussoir
