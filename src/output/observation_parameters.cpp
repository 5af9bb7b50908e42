#include "output/observation_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ObservationParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks, "set of blocks that is looked at", Presence::optional,
              "Give \"all\" or a set of the mesh.");
  section.add_choice<Place>(
      "place", place, {{"nearest node", Place::nearest_node}, {"mean", Place::mean}, {"support", Place::support}},
      "the node of these blocks nearest to (x, y), in space (x, y, z), the mean motion of their mass points, or a "
      "support: its mean motion and its force on the structure");
  section.add("x", x, "m", any_number(), "where the nearest node is sought, before loading");
  section.add("y", y, "m", any_number(), "where the nearest node is sought, before loading");
  section.add("z", z, "m", any_number(), "where the nearest node is sought in space, before loading");
  section.add("tolerance", tolerance, "m", at_least(0.0), "largest distance from there to the nearest node",
              "a distance", "Half the element size is enough on the outside of the structure.");
  section.add("support", support, "support that is observed, where place is \"support\"");
  section.check(place != Place::support || !support.empty(), "support", "", "is missing: place is \"support\"",
                "Name one of the supports of the scene.");
  section.check(place == Place::support || support.empty(), "support", support,
                "is given, but place is not \"support\"", "Set place to \"support\", or leave support out.");
}

}  // namespace voussoir
