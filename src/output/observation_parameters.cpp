#include "output/observation_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ObservationParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks, "set of blocks that is looked at", Presence::optional,
              "Give \"all\" or a set of the mesh.");
  section.add_choice<Place>("place", place, {{"nearest node", Place::nearest_node}, {"mean", Place::mean}},
                            "the node of these blocks nearest to (x, y), or the mean motion of their mass points");
  section.add("x", x, "m", any_number(), "where the nearest node is sought, before loading");
  section.add("y", y, "m", any_number(), "where the nearest node is sought, before loading");
  section.add("tolerance", tolerance, "m", at_least(0.0), "largest distance from (x, y) to the nearest node",
              "a distance", "Half the element size is enough on the outside of the structure.");
}

}  // namespace voussoir
