#include "homogenisation/coarse_operator_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void CoarseOperatorParameters::declare(ParameterSection& section) {
  section.add("krylov to factor", krylov_to_factor, "-", between(1, 1e6),
              "Krylov iterations after which a system is factored whole; more where factoring takes as long as more. "
              "Reason: whole.md");
  section.add(
      "bytes of factors", bytes_of_factors, "B", above(0.0),
      "that factors of a whole system may be expected to have, times the most unknowns of one that is factored. "
      "Reason: what those of the plane have per unknown; in space they fill in more the larger the system is");
  section.add(
      "work per entry", work_per_entry, "-", above(0.0),
      "operations of factoring that take as long as a Krylov iteration, per entry of the system. Reason: 30 for "
      "systems of 4000 unknowns to 120 for 40 000 in space; an iteration passes over as many entries some ten "
      "times and waits for memory, factoring does not");
  section.add("largest region", largest_region, "-", above(0.0),
              "largest share of all unknowns in them. Reason: beyond, factors cost more than iterations save "
              "(released_region.md)");
  section.add("largest factor", largest_factor, "-", between(1, 1e9),
              "unknowns of the continuum up to which it is factored where stones are uneven. Reason: up to there it "
              "is hardly dearer");
  section.add(
      "motions on first rank", motions_on_first, "-", between(0, 1e9),
      "block motions up to which the first of several ranks factors them for all; beyond, groups of blocks stand "
      "above blocks. Reason: below, building levels takes longer than what two ranks save by them "
      "(drivers/ranks.md)");
}

}  // namespace voussoir
