#include "loads/load_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void SelfWeightParameters::declare(ParameterSection& section) {
  section.add("gravity", gravity, "m/s2", any_number(), "weight per mass, downwards (-y)");
}

void AccelerationParameters::declare(ParameterSection& section) {
  section.add("ax", ax, "m/s2", any_number(), "force per mass on every block, to the right; 0.15 g = 1.4715");
  section.add("ay", ay, "m/s2", any_number(), "force per mass on every block, upwards");
}

void TractionParameters::declare(ParameterSection& section) {
  section.add("on", on, "set of facets the traction acts on; it keeps its direction when they turn", Presence::required,
              "Give a set of facets of the mesh; walls have base, top, left, right.");
  section.add("tx", tx, "Pa", any_number(), "traction to the right");
  section.add("ty", ty, "Pa", any_number(), "traction upwards");
  section.add("pressure", pressure, "Pa", any_number(), "against the outward normal, added to (tx, ty)");
}

void SettlementParameters::declare(ParameterSection& section) {
  section.add("support", support, "name of the support of this scene that moves; only its held components do",
              Presence::required, "Give a name from the section \"supports\".");
  section.add("ux", ux, "m", any_number(), "displacement to the right");
  section.add("uy", uy, "m", any_number(), "displacement upwards; a settlement is negative");
  section.add("rotation", rotation, "rad", any_number(), "small rotation, counter-clockwise");
  section.add("about x", about_x, "m", any_number(), "centre of the rotation");
  section.add("about y", about_y, "m", any_number(), "centre of the rotation");
}

void LoadParameters::declare(ParameterSection& section) {
  section.add_choice<LoadType>("type", type,
                               {{"self weight", LoadType::self_weight},
                                {"acceleration", LoadType::acceleration},
                                {"traction", LoadType::traction},
                                {"settlement", LoadType::settlement}},
                               "kind of load; the other keys depend on it", Presence::required);
  section.add_alternative("", self_weight, type == LoadType::self_weight, "type = self weight",
                          "Weight of every block");
  section.add_alternative("", acceleration, type == LoadType::acceleration, "type = acceleration",
                          "The same force per mass on every block");
  section.add_alternative("", traction, type == LoadType::traction, "type = traction", "Force per area on facets");
  section.add_alternative("", settlement, type == LoadType::settlement, "type = settlement",
                          "Prescribed motion of a support");
  section.add_section("time function", time_function, "how the load varies with time, times its factor of the stage");
}

}  // namespace voussoir
