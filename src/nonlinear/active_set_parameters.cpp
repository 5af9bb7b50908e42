#include "nonlinear/active_set_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void ActiveSetParameters::declare(ParameterSection& section) {
  section.add("damping", damping,
              "a solve that loses a stone is made again with points that yield slowly; in patches always. Reason: "
              "stones that nothing holds would fly");
  section.add("step lengths", step_lengths,
              "in time steps are shortened while residuals grow. Reason: without it residuals grew tenfold with "
              "every solve in 12 of the first 76 time steps of the bridge in its earthquake");
  section.add("creeping", creeping,
              "closed points resist more while forces creep with the statuses they have. Reason: one stone on two "
              "whose beds are not one plane creeps by 8 N a solve on the bridge");
  section.add("augmentation in time", augmentation_in_time, "-", above(0.0),
              "resistance of closed points in time, relative to their local stiffness. Reason: the bridge in its "
              "earthquake takes 10 solves a step with 100, 5.4 with 1000, 6.5 with 10^4");
  section.add("augmentation at rest", augmentation_at_rest, "-", above(0.0),
              "the same in load steps. Reason: as many solves as with 1000 on walls and arches, and fewer Krylov "
              "iterations");
  section.add("augmentation of creeping", augmentation_of_creeping, "-", above(0.0),
              std::string("the same while forces creep. ") + no_reason);
  section.add("accuracy", accuracy, "-", inside(0.0, 1.0),
              "of linear solves, relative to their right side. Reason: what a solve leaves looks like points that "
              "change: 1e-2 takes 2.2 times the solves on the bridge in its earthquake");
  section.add("finest accuracy", finest_accuracy, "-", inside(0.0, 1.0),
              "of linear solves in time where statuses stay. Reason: round-off");
  section.add("patience", patience, "-", between(1, 1e6),
              std::string("solves that gain too little after which it circles. ") + no_reason);
  section.add("patience alone", patience_alone, "-", between(1, 1e6),
              "the same where stones cannot be brought to rest alone. Reason: another way is cheaper there than to "
              "find out");
  section.add("gained", gained, "-", inside(0.0, 1.0),
              std::string("share of the best residual below which a solve has gained. ") + no_reason);
  section.add("many krylov", many_krylov, "-", between(1, 1e6),
              std::string("Krylov iterations of a first solve that mean loose stones: another way is "
                          "taken. ") +
                  no_reason);
  section.add("most krylov", most_krylov, "-", between(1, 1e6),
              "Krylov iterations of later solves. Reason: stones that flew make right sides large");
  section.add("near", near, "-", above(0.0),
              std::string("residual below which loose stones are no reason to leave. ") + no_reason);
  section.add("flown", flown, "-", above(0.0),
              "right sides are solved as accurately as if they were no more than so many times the largest force. "
              "Reason: those of stones that flew are, and what a solve leaves of them must not push the others");
  section.add("descent", descent, "-", inside(0.0, 1.0),
              std::string("share of a step by which squared residuals must fall in time. ") + no_reason);
  section.add("shortest", shortest, "-", inside(0.0, 1.0), std::string("shortest step in time. ") + no_reason);
  section.add("lost", lost, "-", above(0.0),
              std::string("growth of the residual that means a lost stone. ") + no_reason);
  section.add("first damping", first_damping, "-", above(0.0),
              std::string("resistance of points that give way once a stone is lost, relative to their "
                          "local stiffness. ") +
                  no_reason);
  section.add("damping factor", damping_factor, "-", above(1.0),
              std::string("by which that rises with every repeated solve, and falls with every step that "
                          "is taken. ") +
                  no_reason);
  section.add("largest damping", largest_damping, "-", above(0.0), std::string("of these resistances. ") + no_reason);
  section.add("no damping", no_damping, "-", above(0.0),
              std::string("resistance below which it is taken for none. ") + no_reason);
  section.add("damped", damped, "-", above(0.0),
              "share of the residual without damping above which nothing was lost. Reason: a point has held against "
              "its law then and lets go next");
  section.add("damping in patch", damping_in_patch, "-", above(0.0),
              "resistance of points that give way in patches. Reason: their stones are moved on and need not fly");
}

}  // namespace voussoir
