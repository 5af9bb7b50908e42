#include "dynamics/construction_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ConstructionParameters::declare(ParameterSection& section) {
  section.add("blocks", blocks, "set of blocks that is built or taken away; a block has one time of being there",
              Presence::required, "Give a set of the mesh.");
  section.add("appears", appears, "stage that begins with these blocks, without stress; left out: from the start");
  section.add("disappears", disappears, "stage that begins without these blocks; left out: never");
}

}  // namespace voussoir
