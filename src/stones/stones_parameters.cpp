#include "stones/stones_parameters.hpp"

#include "base/file_ending.hpp"
#include "base/parameter_section.hpp"
#include "base/text.hpp"
#include "base/words.hpp"

namespace voussoir {

bool StonesParameters::is_drawing() const {
  const std::string ending = lower_ending(file);
  return ending == ".csv" || ending == ".dxf" || ending == ".svg" || ending == ".geojson";
}

namespace {

/// Keys of space that a drawing has no use for, and the other way round.
void check_kind(ParameterSection& section, const StonesParameters& p) {
  const bool drawn = p.is_drawing();
  const auto refuse_where = [&](bool given, const std::string& key, const std::string& value,
                                const std::string& advice) {
    section.check(!given, key, value,
                  drawn ? "is of stones in space, and the file is a drawing in the plane"
                        : "is of drawings in the plane, and the file has stones in space",
                  advice);
  };
  if (drawn) {
    refuse_where(p.joint_tolerance > 0, "joint tolerance", number_text(p.joint_tolerance) + " [m]", "Give snap.");
    refuse_where(p.weld > 0, "weld", number_text(p.weld) + " [m]", "Give snap.");
    refuse_where(p.up == UpAxis::z, "up", "\"z\"", "Give usual, y, x or -y.");
    refuse_where(p.cells == StoneCells::tetrahedra, "cells", "\"tetrahedra\"",
                 "Give by shape, triangles or quadratic triangles.");
    refuse_where(p.element != StoneElement::quadratic, "element", "\"linear\"", "Leave it out.");
    refuse_where(!p.geometry.empty(), "geometry", "", "Leave it out.");
  } else {
    refuse_where(p.snap > 0, "snap", number_text(p.snap) + " [m]", "Give joint tolerance and weld.");
    refuse_where(p.up == UpAxis::minus_y, "up", "\"-y\"", "Give usual, x, y or z.");
    refuse_where(p.cells == StoneCells::triangles, "cells", "\"triangles\"", "Give by shape or tetrahedra.");
    refuse_where(p.cells == StoneCells::quadratic_triangles, "cells", "\"quadratic triangles\"",
                 "Give by shape or tetrahedra.");
  }
}

}  // namespace

void StonesParameters::declare(ParameterSection& section) {
  section.add(
      "file", file,
      "stones as closed surfaces: .obj (an object is a stone, or each closed group in it), .json of COMPAS (meshes, an "
      "Assembly, a BlockModel), .stl, .ply, or a folder of such files, one each; or solids: .step, or .geo and .msh of "
      "gmsh, every volume of which is a stone. A scene of the plane has a drawing: .csv (a row for each corner: stone, "
      "x, y, and where wanted set and hole), .dxf (closed polylines, circles; the layer is a set), .svg (closed paths "
      "and shapes; id is the name, class a set), .geojson (polygons; name, set). A relative path is sought beside the "
      "scene, then in its parent folder and the folder meshes/ of that",
      Presence::required, "Give the path of a file of stones, such as meshes/vault.obj.");
  section.add("unit", unit, "m", above(0.0).usually(1e-3, 1), "length that the file calls 1; STEP says its own",
              "a length; a file of stones need not say its unit", "Give 0.001 for a file in millimetres.");
  section.add_choice<UpAxis>(
      "up", up,
      {{"usual", UpAxis::usual}, {"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}, {"-y", UpAxis::minus_y}},
      "axis of the file that points up: in space z, x or y, usual: z; of a drawing y, x or -y (y runs down the page), "
      "usual: -y of .svg, y of others");
  section.add(
      "snap", snap, "m", at_least(0.0),
      "drawings: corners of stones that are nearer than this become one point, and edges are split at corners of "
      "others that are as near; 0 = from the middle of the widest range in which the drawing fits together and "
      "has equally many joints, which is told when the file is read",
      "a length", "Give 0 to have it chosen.");
  section.add(
      "joint tolerance", joint_tolerance, "m", at_least(0.0),
      "two faces are a joint where they are nearer than this; 0 = 0.002 of the median stone (cube root of its "
      "volume). The number of joints over the tolerance is told when the file is read: take one from the middle "
      "of where it does not change",
      "a length", "Give 0 to have it chosen.");
  section.add(
      "weld", weld, "m", at_least(0.0),
      "corners of stones that are nearer than this become one, and faces whose corners all do a joint, which is told; "
      "0 = 3 x joint tolerance. Stones that were measured want 2 to 10 of it",
      "a length", "Give 0 to have it chosen.");
  section.add(
      "element size", element_size, "m", at_least(0.0),
      "wanted length of cell edges; 0 = a quarter of the median stone (cube root of its volume, square root of its "
      "area), of quadratic "
      "tetrahedra two fifths, of files of gmsh what they say. A .msh is meshed anew by it",
      "a length", "Give 0 to have it chosen.");
  section.add_choice<StoneCells>(
      "cells", cells,
      {{"by shape", StoneCells::by_shape},
       {"tetrahedra", StoneCells::tetrahedra},
       {"triangles", StoneCells::triangles},
       {"quadratic triangles", StoneCells::quadratic_triangles}},
      "by shape: hexahedra where a stone and all it touches, directly or through others, "
      "are boxes that joints cut along "
      "lattice lines, else tetrahedra. Volumes of gmsh whose meshes match node to node keep "
      "their cells. Of a drawing: quadrilaterals where a stone has four sides, else triangles; or triangles alone, "
      "quadratic ones of which bend along their edges, but for edges on joints and supports");
  section.add_choice<StoneElement>(
      "element", element, {{"quadratic", StoneElement::quadratic}, {"linear", StoneElement::linear}},
      "tetrahedra: quadratic ones bend along their edges, but for edges on joints and supports, and are condensed to "
      "the corners of each stone, so the unknowns are those of linear ones and the error in displacements a seventh "
      "and less; linear ones are the check, and take a tenth of the memory");
  section.add_numbers("geometry", geometry, "", any_number(),
                      "numbers set in a .geo by their name, such as span = 4.5, in the units of the file");
  check_kind(section, *this);
}

}  // namespace voussoir
