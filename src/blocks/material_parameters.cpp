#include "blocks/material_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {
namespace {

/// Squares of stiffnesses, of their inverses and of what they are multiplied by stay within the numbers a computer holds.
void check_computable(ParameterSection& section, const std::string& name, double value, const std::string& unit) {
  constexpr double least = 1e-30, most = 1e30;
  section.check(least <= value && value <= most, name, number_text(value) + " [" + unit + "]",
                "must be >= " + number_text(least) + " and <= " + number_text(most) +
                    " (what follows from it is beyond the numbers a computer holds)",
                "Give it in " + unit);
}

}  // namespace

void ModelParameters::declare(ParameterSection& section) {
  section.add_choice<Plane>("plane", plane, {{"stress", Plane::stress}, {"strain", Plane::strain}},
                            "plane stress for a facade or ring that is free to widen, plane strain for a slice of "
                            "something long");
  section.add("thickness", thickness, "m", above(0.0).usually(0.01, 100), "thickness out of plane",
              "masses and forces grow with it", "Give the depth of the stones, or 1 for results per metre.");
  check_computable(section, "thickness", thickness, "m");
  section.add_choice<Rotations>("rotations", rotations, {{"small", Rotations::small}, {"finite", Rotations::finite}},
                                "small: equilibrium of the stones as drawn; finite: where they have moved and turned "
                                "to, in load steps without time or construction");
}

void MaterialParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks, "set of blocks made of it; a later material goes before an earlier one",
              Presence::optional, "Give \"all\" or a set of the mesh.");
  section.add("Young modulus", young_modulus, "Pa", above(0.0).usually(1e6, 1e12), "Young's modulus E",
              "a block without stiffness cannot carry", "Sandstone has 5e9 to 30e9, brick 2e9 to 15e9.");
  check_computable(section, "Young modulus", young_modulus, "Pa");
  section.add("Poisson ratio", poisson_ratio, "-", inside(-1.0, 0.5), "Poisson's ratio",
              "beyond it the elastic energy is not positive, at 0.5 the stone is incompressible",
              "Stone has 0.1 to 0.3.");
  section.add("density", density, "kg/m3", above(0.0).usually(200, 10000), "mass per volume",
              "weight and inertia come from it", "Stone has 1800 to 2700.");
  check_computable(section, "density", density, "kg/m3");
}

}  // namespace voussoir
