#include "loads/common_keys.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void declare_facet_set(ParameterSection& section, std::string& on, std::string& blocks) {
  section.add("on", on, "set of facets the load acts on; it keeps its direction when they turn", Presence::required,
              "Give a set of facets of the mesh; walls have base, top, left, right, in space front and back.");
  section.add("blocks", blocks,
              "set of blocks whose facets alone are loaded: says which side of a joint; all: both sides are meant");
}

void declare_block_set(ParameterSection& section, std::string& blocks) {
  section.add("blocks", blocks, "set of blocks the load acts on", Presence::optional,
              "Give \"all\" or a set of the mesh.");
}

void declare_gravity(ParameterSection& section, double& gravity) {
  section.add("gravity", gravity, "m/s2", any_number().usually(1, 100),
              "of the earth, downwards (-y, in space -z) where masses are weighed");
}

void declare_water(ParameterSection& section, double& level, double& density, double& gravity) {
  section.add("level", level, "m", any_number(), "height (y, in space z) of the water");
  section.add("density", density, "kg/m3", at_least(0.0).usually(500, 2000), "of the water", "a density",
              "Fresh water has 1000.");
  declare_gravity(section, gravity);
}

}  // namespace voussoir
