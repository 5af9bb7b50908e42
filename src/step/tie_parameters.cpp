#include "step/tie_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void TieParameters::declare(ParameterSection& section) {
  section.add("noise", noise, "-", above(0.0),
              std::string("times the tolerance below which what a block lacks is nothing. ") + no_reason);
  section.add("balanced", balanced, "-", above(0.0),
              "share of their magnitudes below which loads of a stone are in balance. Reason: round-off");
  section.add("largest share", largest_share, "-", above(0.0),
              "of the load of a stone that ties may bear beyond the law where all stones move. Reason: relaxation "
              "leaves no more of own weight on walls up to W(128)");
  section.add("largest share alone", largest_share_alone, "-", above(0.0),
              "the same of a stone alone between its neighbours. Reason: the accuracy of load factors");
  section.add("share of step", share_of_step, "-", inside(0.0, 1.0),
              "of the step to balance that stones take. Reason: what Jacobi's method bears between two springs");
  section.add("momentum", momentum, "-", inside(0.0, 1.0),
              "share of its last way that a stone rolls on. Reason: best where balance is a dozen stones away: (1 - "
              "1/12)^2 = 0.84");
  section.add("patience", patience, "-", between(1, 1e6),
              "sweeps without progress after which no balance is found. Reason: a push has crossed as many stones by "
              "then");
  section.add("progress", progress, "-", inside(0.0, 1.0),
              std::string("share of what all stones lack below which a sweep is progress. ") + no_reason);
  section.add("foundation", foundation, "-", above(0.0),
              std::string("stiffness under a stone that no point touches in some direction, relative to "
                          "its points. ") +
                  no_reason);
  section.add("steps alone", steps_alone, "-", between(1, 1e6),
              "steps of a stone alone. Reason: those that stand take some dozens at most");
}

}  // namespace voussoir
