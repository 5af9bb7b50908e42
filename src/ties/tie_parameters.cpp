#include "ties/tie_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void TieParameters::declare(ParameterSection& section) {
  section.add("largest share", largest_share, "-", above(0.0),
              "of the load of a stone that ties may bear beyond the law where all stones move. Reason: relaxation "
              "leaves no more of own weight on walls up to W(128)");
  section.add("largest share alone", largest_share_alone, "-", above(0.0),
              "the same of a stone alone between its neighbours. Reason: the accuracy of load factors");
  section.add("momentum", momentum, "-", inside(0.0, 1.0),
              "share of its last way that a stone rolls on. Reason: best where balance is a dozen stones away: (1 - "
              "1/12)^2 = 0.84");
  section.add(
      "patience", patience, "-", between(1, 1e6),
      "sweeps without progress after which no balance is found; of more stones than its square: as many as lie along "
      "the side of a square of them. Reason: a push has crossed as many by then; with 50 W(160) takes 17 solves, 7 "
      "with 100");
}

}  // namespace voussoir
