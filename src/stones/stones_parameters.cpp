#include "stones/stones_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void StonesParameters::declare(ParameterSection& section) {
  section.add(
      "file", file,
      "stones as closed surfaces: .obj (an object or a group is a stone), .json of COMPAS (meshes, an Assembly, "
      "a BlockModel), .stl, .ply, or a folder of such files, one for each stone; or solids: .step, or .geo and .msh of "
      "gmsh, every volume of which is a stone; a relative path is sought "
      "beside the scene, then in its parent folder and the folder meshes/ of that",
      Presence::required, "Give the path of a file of stones, such as meshes/vault.obj.");
  section.add("unit", unit, "m", above(0.0).usually(1e-3, 1), "length that the file calls 1",
              "a length; files of stones do not say their unit", "Give 0.001 for a file in millimetres.");
  section.add_choice<UpAxis>("up", up, {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}},
                             "axis of the file that points up; in the scene that is z");
  section.add(
      "joint tolerance", joint_tolerance, "m", at_least(0.0),
      "two faces are a joint where they are nearer than this; 0 = 0.002 of the median stone (cube root of its "
      "volume). The number of joints over the tolerance is told when the file is read: take one from the middle "
      "of where it does not change",
      "a length", "Give 0 to have it chosen.");
  section.add(
      "weld", weld, "m", at_least(0.0),
      "corners of stones that are nearer than this become one; 0 = 3 x joint tolerance. Stones that were measured "
      "want 2 to 10 of it",
      "a length", "Give 0 to have it chosen.");
  section.add("element size", element_size, "m", at_least(0.0),
              "wanted length of cell edges; 0 = a quarter of the median stone (cube root of its volume), of quadratic "
              "tetrahedra two fifths, of files of gmsh what they say. A .msh is meshed anew by it",
              "a length", "Give 0 to have it chosen.");
  section.add_choice<StoneCells>("cells", cells,
                                 {{"by shape", StoneCells::by_shape}, {"tetrahedra", StoneCells::tetrahedra}},
                                 "by shape: hexahedra where a stone and all it touches, directly or through others, "
                                 "are boxes that joints cut along "
                                 "lattice lines, else tetrahedra. Volumes of gmsh whose meshes match node to node keep "
                                 "their cells");
  section.add_choice<StoneElement>(
      "element", element, {{"quadratic", StoneElement::quadratic}, {"linear", StoneElement::linear}},
      "tetrahedra: quadratic ones bend along their edges, but for edges on joints and supports, and are condensed to "
      "the corners of each stone, so the unknowns are those of linear ones and the error in displacements a seventh "
      "and less; linear ones are the check, and take a tenth of the memory");
  section.add_numbers("geometry", geometry, "", any_number(),
                      "numbers set in a .geo by their name, such as span = 4.5, in the units of the file");
}

}  // namespace voussoir
