#include "dynamics/load_step_parameters.hpp"

#include "base/parameter_section.hpp"
#include "base/text.hpp"

namespace voussoir {

void StageParameters::declare(ParameterSection& section) {
  section.add("increments", increments, "-", between(1, 1e6), "equal load steps of this stage",
              "a stage needs one step");
  section.add("duration", duration, "s", at_least(0.0).usually(1e-7, 1e5),
              "time this stage takes, in time steps with mass; 0 = load steps without mass", "time goes forward",
              "Give 0 for load steps.");
  section.add("time step", time_step, "s", at_least(0.0).usually(1e-9, 1),
              "time step of a stage with duration, which takes the mean of the loads over it; 0 = automatic",
              "time goes forward", "Give 0 to let the program choose.");
  section.check(time_step == 0 || time_step <= duration, "time step", number_text(time_step) + " s",
                "must be <= duration = " + number_text(duration) + " s (a stage needs one step)",
                "Give 0 to let the program choose, or a duration");
  section.add("at once", at_once,
              "true: in a stage with duration the loads have their factors from its first moment on, instead of going "
              "there linearly; not for what moves a support");
  section.add_numbers("loads", factors, "-", any_number(),
                      "factor of each load at the end of the stage; a load not named keeps its factor (0 at first)");
}

void LoadStepParameters::declare(ParameterSection& section) {
  section.add("largest halvings", largest_halvings, "-", between(0, most_halvings),
              "how often a load step that does not converge may be halved",
              "after 30 halvings a step is 1e-9 of its size", "Give 0 to stop at the first failure; 4 is usual.");
  section.add("expect collapse", expect_collapse,
              "true when the aim of the scene is its collapse: finding it then counts as done");
  section.add(
      "at most", at_most, "s", at_least(0.0).usually(1, 1e6),
      "time of the clock that a run may take: then it saves its state and ends with what is known, the bracket or "
      "the last step, and can be gone on with; 0 = as long as it takes",
      "a run takes time", "Give 0 to let the run come to its end.");
}

}  // namespace voussoir
