#include "nonlinear/patch_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void PatchParameters::declare(ParameterSection& section) {
  section.add("used", used,
              "stones that keep a load step from closing are brought to rest alone. Reason: nonlinear elimination: "
              "Lanzkron, Rose, Wilkes (1996)");
  section.add("trigger", trigger, "-", above(0.0),
              "share of the best residual above which a solve has left stuck stones. Reason: with the right statuses "
              "a solve leaves a hundredth");
  section.add("more rings", more_rings, "-", between(0, 1000),
              "rings of neighbours that a patch which passes on too much may gain. Reason: each doubles a small patch");
}

}  // namespace voussoir
