#include "nonlinear/contact_solver_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ContactSolverParameters::declare(ParameterSection& section) {
  section.add("active sets", active_sets, "active sets are tried first");
  section.add("shortcut", shortcut, "active sets are tried again near the end of the path");
  section.add("back off", back_off,
              "active sets that failed are left out of the load steps that follow, for longer after every failure. "
              "Reason: where they fail they tend to fail again");
  section.add("longest wait", longest_wait, "-", between(0, 1000),
              std::string("solves that active sets are left out of at most. ") + no_reason);
  section.add("solves in time", solves_in_time, "-", between(1, 1e6),
              "linear solves of active sets in a time step. Reason: those that arrive take up to 20");
  section.add("solves at rest", solves_at_rest, "-", between(1, 1e6),
              "linear solves of active sets in a load step. Reason: those that arrive take up to 15");
  section.add("solves from near", solves_from_near, "-", between(1, 1e6),
              "linear solves of active sets from near the end of the path. Reason: after 20 the wall W(512) stopped "
              "just short of its tolerance, and what follows is slower");
  section.add("patience from near", patience_from_near, "-", between(1, 1e6),
              "solves without a gain after which they give up there. Reason: the path goes on and offers a better "
              "state");
  section.add("closing solves", closing_solves, "-", between(1, 1e4),
              "linear solves of the augmented Lagrangian before another path is tried. Reason: those that arrive "
              "from a path took up to 75");
  section.add("most doublings", most_doublings, "-", between(0, 16),
              "doublings of that number, one after every path that led nowhere. Reason: what is followed then may be "
              "a mechanism, which takes hundreds of solves");
  section.add("largest path", largest_path, "-", between(1, 1e6),
              "steps of the path. Reason: paths that arrive took up to 130");
}

}  // namespace voussoir
