#include "homogenisation/coarse_operator_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void CoarseOperatorParameters::declare(ParameterSection& section) {
  section.add("same", same, "-", above(0.0),
              "change of a resistance up to which factors stay. Reason: eigenvalues of S H and Q H move by no more "
              "than that");
  section.add("krylov to factor", krylov_to_factor, "-", between(1, 1e6),
              "Krylov iterations after which a system is factored whole. Reason: whole.md");
  section.add("largest region", largest_region, "-", above(0.0),
              "largest share of all unknowns in them. Reason: beyond, factors cost more than iterations save "
              "(released_region.md)");
  section.add("even", even, "-", above(0.0),
              "ratio of the stiffest stone to the softest up to which multigrid will do. Reason: beyond, a "
              "factorisation takes a third of its iterations");
  section.add("largest factor", largest_factor, "-", between(1, 1e9),
              "unknowns of the continuum up to which it is factored where stones are uneven. Reason: up to there it "
              "is hardly dearer");
}

}  // namespace voussoir
