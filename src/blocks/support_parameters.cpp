#include "blocks/support_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void SupportParameters::declare(ParameterSection& section) {
  section.add("on", on, "set of facets that is held", Presence::required,
              "Give a set of facets of the mesh; walls have base, top, left, right, in space front and back.");
  section.add_choice<std::string>(
      "components", components,
      {{"all", "all"},
       {"xy", "xy"},
       {"x", "x"},
       {"y", "y"},
       {"z", "z"},
       {"xz", "xz"},
       {"yz", "yz"},
       {"normal", "normal"}},
      "components of the displacement that are held, z in space alone; the others are "
      "free. normal: the one across each facet, which slides freely along itself, however it is inclined");
  section.add("blocks", blocks,
              "set of blocks whose facets alone are held: says which side of a joint; all: both sides are meant");
}

}  // namespace voussoir
