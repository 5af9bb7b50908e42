#include "linalg/solver_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void SolverParameters::declare(ParameterSection& section) {
  section.add_choice<std::string>(
      "method", method, {{"CG", "CG"}, {"PSEUDOBLOCK CG", "PSEUDOBLOCK CG"}, {"FLEXIBLE GMRES", "FLEXIBLE GMRES"}},
      "Krylov method of Belos; the systems are symmetric positive definite, so CG is the cheapest");
  section.add_choice<std::string>(
      "unsymmetric method", unsymmetric_method,
      {{"BICGSTAB", "BICGSTAB"}, {"BLOCK GMRES", "BLOCK GMRES"}, {"FLEXIBLE GMRES", "FLEXIBLE GMRES"}},
      "Krylov method of Belos for systems in which friction follows the pressure");
  section.add("largest iterations", largest_iterations, "-", between(1, 1e6), "of a linear solve",
              "none would solve nothing");
  section.add_list("Belos", belos, "parameters for Belos, going before those Voussoir sets; its manual applies");
  section.add_list("Belos unsymmetric", belos_unsymmetric, "the same for the unsymmetric method");
  section.add_list("MueLu", muelu,
                   "parameters for MueLu, going before those Voussoir sets; its manual applies. With any, a continuum "
                   "of unequal stones is not factored either");
}

}  // namespace voussoir
