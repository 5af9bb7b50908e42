#include "selection/selection_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void SelectionParameters::declare(ParameterSection& section) {
  section.add_choice<SelectionMode>(
      "mode", mode,
      {{"adaptive", SelectionMode::adaptive}, {"all", SelectionMode::all}, {"bonded", SelectionMode::bonded}},
      "contact points resolved as contact: those that matter, all, or none");
  section.add("error tolerance", error_tolerance, "-", from_below(0.0, 1.0),
              "wanted relative error in the energy norm, half of it in scenes that take time; 0 resolves every point "
              "that violates the law. It is compared with an estimate, which is no bound; single displacements may be "
              "several times as far off, with 0.01 by several percent (mode all has no such error). Beside this norm a "
              "local criterion asks stone by stone: where lawful forces of its joints do not balance a stone, all of "
              "these joints are released, however small the error",
              "1 would accept anything", "0.01 is usual.");
  section.add("bulk", bulk, "-", above_up_to(0.0, 1.0), "share of the predicted decrease of energy a round releases",
              "a round that releases nothing makes no progress", "0.9 is usual, 1 releases all that violate.");
  section.add("whole joints", whole_joints, "release all points of the joint of a marked point");
  section.add("largest share", largest_share, "-", above_up_to(0.0, 1.0),
              "share of points, seen one round ahead, above which all are resolved: tying so few saves no solves",
              "0 would select all at once, which is mode all", "0.5 is usual, 1 ties whatever can be tied.");
  section.add("largest rounds", largest_rounds, "-", between(1, 1e6), "rounds of release in one load step",
              "the first round is the solution itself");
  section.add("rest", rest, "-", between(0, 1e6),
              "time steps without opening or slip after which a point is bonded again as it stands; twice as many "
              "where it had to be released soon after; 0 = never",
              "rest takes time", "10 is usual.");
}

}  // namespace voussoir
