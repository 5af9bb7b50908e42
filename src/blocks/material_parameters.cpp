#include "blocks/material_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ModelParameters::declare(ParameterSection& section) {
  section.add_choice<Plane>("plane", plane, {{"stress", Plane::stress}, {"strain", Plane::strain}},
                            "plane stress for a facade or ring that is free to widen, plane strain for a slice of "
                            "something long");
  section.add("thickness", thickness, "m", above(0.0).usually(0.01, 100), "thickness out of plane",
              "masses and forces grow with it", "Give the depth of the stones, or 1 for results per metre.");
  section.add_choice<Hexahedra>(
      "hexahedra", hexahedra, {{"incompatible modes", Hexahedra::incompatible}, {"plain", Hexahedra::plain}},
      "cells in space: with incompatible modes of their own, in which they bend; plain ones bend only by shearing, and "
      "are too stiff where a stone has few");
  section.add_choice<Rotations>("rotations", rotations, {{"small", Rotations::small}, {"finite", Rotations::finite}},
                                "small: equilibrium of the stones as drawn; finite: where they have moved and turned "
                                "to, in load steps without time or construction");
}

void MaterialParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks, "set of blocks made of it; a later material goes before an earlier one",
              Presence::optional, "Give \"all\" or a set of the mesh.");
  section.add("Young modulus", young_modulus, "Pa", above(0.0).usually(1e6, 1e12), "Young's modulus E",
              "a block without stiffness cannot carry", "Sandstone has 5e9 to 30e9, brick 2e9 to 15e9.");
  section.add("Poisson ratio", poisson_ratio, "-", inside(-1.0, 0.5), "Poisson's ratio",
              "beyond it the elastic energy is not positive, at 0.5 the stone is incompressible",
              "Stone has 0.1 to 0.3.");
  section.add("density", density, "kg/m3", above(0.0).usually(200, 10000), "mass per volume",
              "weight and inertia come from it", "Stone has 1800 to 2700.");
  section.add("thickness", thickness, "m", at_least(0.0).usually(0.01, 100),
              "of its blocks out of plane; 0 = model > thickness. A joint between two thicknesses bears on the smaller",
              "a length", "Give 0 for that of the model.");
}

}  // namespace voussoir
