#include "time/time_step_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void TimeStepParameters::declare(ParameterSection& section) {
  section.add("velocity accuracy", velocity_accuracy, "-", inside(0.0, 1.0),
              "of the projection of velocities. Reason: less lets runs on 1 and 2 ranks part");
}

}  // namespace voussoir
