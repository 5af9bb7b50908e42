#include "dynamics/load_step_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void StageParameters::declare(ParameterSection& section) {
  section.add("increments", increments, "-", between(1, 1e6), "equal load steps of this stage",
              "a stage needs one step");
  section.add_numbers("loads", factors, "-", any_number(),
                      "factor of each load at the end of the stage; a load not named keeps its factor (0 at first)");
}

void LoadStepParameters::declare(ParameterSection& section) {
  section.add("largest halvings", largest_halvings, "-", between(0, 30),
              "how often a load step that does not converge may be halved",
              "after 30 halvings a step is 1e-9 of its size", "Give 0 to stop at the first failure; 4 is usual.");
  section.add("expect collapse", expect_collapse,
              "true when the aim of the scene is its collapse: finding it then counts as done");
}

}  // namespace voussoir
