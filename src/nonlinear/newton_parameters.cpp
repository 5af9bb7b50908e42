#include "nonlinear/newton_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void NewtonParameters::declare(ParameterSection& section) {
  section.add("tolerance", tolerance, "-", between(1e-14, 1e-2),
              "residual of equilibrium and contact conditions, relative to the largest force",
              "1e-14 is round-off, beyond 1e-2 nothing is solved", "1e-8 is usual.");
  section.add("largest iterations", largest_iterations, "-", between(1, 1e6),
              "linear solves of one load step before it counts as not converged", "none would solve nothing");
}

}  // namespace voussoir
