#include "nonlinear/contact_solver_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ContactSolverParameters::declare(ParameterSection& section) {
  section.add("active sets", active_sets, "active sets are tried first");
  section.add("shortcut", shortcut, "active sets are tried again near the end of the path");
  section.add(
      "back off", back_off,
      "active sets that failed are left out of the load steps that follow, of twice as many after every failure. "
      "Reason: where they fail they tend to fail again");
  section.add("fast solves", fast_solves, "-", between(1, 1e6),
              "linear solves of active sets. Reason: those that arrive take up to 20");
  section.add("largest path", largest_path, "-", between(1, 1e6),
              "steps of the path. Reason: those that arrive take up to 130, those of patches of large walls up to 142");
}

}  // namespace voussoir
