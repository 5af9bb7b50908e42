#include "nonlinear/patch_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PatchParameters::declare(ParameterSection& section) {
  section.add("used", used,
              "stones that keep a load step from closing are brought to rest alone. Reason: nonlinear elimination: "
              "Lanzkron, Rose, Wilkes (1996)");
}

}  // namespace voussoir
