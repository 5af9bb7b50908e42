#include "nonlinear/pseudo_time_parameters.hpp"

#include <string>

#include "base/parameter_section.hpp"

namespace voussoir {

void PseudoTimeParameters::declare(ParameterSection& section) {
  section.add("used", used, "pseudo-time follows where the path ends early, and tells collapses");
  section.add("drag", drag, "-", above(0.0),
              "of the first step, relative to the proximal weights of the problem. Reason: with it a structure that "
              "is out of balance by a hundredth of its weight moves by a thousandth of its size");
  section.add("factor", factor, "-", above(1.0),
              "by which the drag falls after a step that arrives, and rises after one that does not. Reason: a step "
              "of ten times the length is another problem; less would take more steps");
  section.add("accuracy", accuracy, "-", inside(0.0, 1.0),
              "of a step, relative to the residual that it begins with. Reason: inexact Newton");
  section.add("run away", run_away, "-", above(0.0),
              "share of the structure that is no elastic displacement of masonry, on the path too. Reason: small "
              "displacements are assumed");
  section.add("unchanged", unchanged, "-", above(0.0),
              "share of the imbalance that a motion without end may change. Reason: it would have to go on as far "
              "again");
  section.add("believable", believable, "-", above(0.0),
              "contact residual, of the largest force, at which a motion without end is believed. Reason: "
              "stones in flight collide");
}

}  // namespace voussoir
