#include "nonlinear/interior_path_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void InteriorPathParameters::declare(ParameterSection& section) {
  section.add("used", used, "the interior path follows where active sets fail, in patches too");
  section.add("folds", folds,
              "friction follows the pressure by less where the path folds. Reason: no path of a convex problem folds");
  section.add("to boundary", to_boundary, "-", inside(0.0, 1.0),
              "share of the step to the boundary that is taken, at most a full step. Reason: slacks stay positive: "
              "Wright (1997)");
  section.add("solve accuracy", solve_accuracy, "-", inside(0.0, 1.0),
              "of linear solves. Reason: 1e-3 takes as many solves and 1.6 times the Krylov iterations on the "
              "bridge; with 3e-2 the deformed bridge does not arrive");
  section.add("patience", patience, "-", between(1, 1e6),
              "steps that gain too little, after which it folds or leads no further. "
              "Reason: steps that cross a fold are short, and friction that follows by less needs some to show");
}

}  // namespace voussoir
