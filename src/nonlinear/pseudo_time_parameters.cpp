#include "nonlinear/pseudo_time_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PseudoTimeParameters::declare(ParameterSection& section) {
  section.add("used", used, "pseudo-time follows where the path ends early, and tells collapses");
  section.add("run away", run_away, "-", above(0.0),
              "share of the structure that is no elastic displacement of masonry, on the path too. Reason: small "
              "displacements are assumed");
}

}  // namespace voussoir
