#include "nonlinear/augmented_lagrangian_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void AugmentedLagrangianParameters::declare(ParameterSection& section) {
  section.add("used", used, "the augmented Lagrangian closes what the path leaves, and tells collapses");
  section.add("largest augmentation", largest_augmentation, "-", above(0.0),
              "relative to the local stiffness. Reason: 1 takes the fewest solves; more only where forces creep");
  section.add("largest proximal", largest_proximal, "-", above(0.0),
              std::string("proximal term at first and where Newton labours, relative to the weights of "
                          "the problem. ") +
                  no_reason);
  section.add("smallest proximal", smallest_proximal, "-", above(0.0),
              std::string("the same while forces creep. ") + no_reason);
  section.add("factor", factor, "-", above(1.0),
              std::string("by which augmentation and proximal term change. ") + no_reason);
  section.add("creeping", creeping, "-", above(0.0),
              std::string("share of the last change of forces above which one step of Newton gained too "
                          "little. ") +
                  no_reason);
  section.add("labouring", labouring, "-", between(1, 1e6),
              std::string("steps of Newton with bounds that follow the pressure, while forces creep. ") + no_reason);
  section.add("struggling", struggling, "-", between(1, 1e6),
              std::string("steps of Newton after which augmentation and proximal term go back. ") + no_reason);
  section.add("stagnating", stagnating, "-", above(0.0),
              std::string("share of the last change of forces above which an outer step stagnates. ") + no_reason);
  section.add("stagnant steps", stagnant_steps, "-", between(0, 1e6),
              std::string("outer steps that may stagnate. ") + no_reason);
  section.add("relaxation", relaxation, "-", inside(0.0, 1.0),
              "by how much friction bounds follow pressures while forces creep. Reason: pressures that go in circles "
              "take the bounds with them");
  section.add("collision step", collision_step, "-", inside(0.0, 1.0),
              std::string("a shorter step ran into points that its direction knew nothing of. ") + no_reason);
  section.add("largest inner", largest_inner, "-", between(1, 1e6),
              std::string("steps of Newton that an update waits for. ") + no_reason);
  section.add("aim", aim, "-", inside(0.0, 1.0),
              "share of the tolerance, and of the last change of forces, to which a minimum is found. Reason: "
              "inexact Newton");
  section.add("solve aim", solve_aim, "-", inside(0.0, 1.0),
              "share of that to which a linear system is solved. Reason: inexact Newton");
  section.add("finest accuracy", finest_accuracy, "-", inside(0.0, 1.0), "of linear solves. Reason: round-off");
  section.add("coarsest accuracy", coarsest_accuracy, "-", inside(0.0, 1.0),
              std::string("of linear solves. ") + no_reason);
  section.add("finest alone", finest_alone, "-", inside(0.0, 1.0),
              "accuracy of the linear solve where no point is selected. Reason: round-off");
  section.add("prediction", prediction, "-", inside(0.0, 1.0),
              "accuracy of the solve that moves supports and loads. Reason: statuses will change; displacements to a "
              "tenth of a percent show how");
  section.add("run away", run_away, "-", above(0.0),
              std::string("share of the structure that is no elastic displacement of masonry, on the "
                          "path too. ") +
                  no_reason);
  section.add("unchanged", unchanged, "-", above(0.0),
              "share of the imbalance that a motion without end may change. Reason: it would have to go on as far "
              "again");
  section.add("believable", believable, "-", above(0.0),
              "contact residual, of the largest force, at which a motion without end is believed. Reason: "
              "stones in flight collide");
  section.add("settled", settled, "-", above(0.0),
              std::string("share of the imbalance below which forces have settled. ") + no_reason);
  section.add("drifting", drifting, "-", above(0.0),
              std::string("share of the last imbalance above which it stays. ") + no_reason);
  section.add("drifting steps", drifting_steps, "-", between(0, 1e6),
              "outer steps of which it may stay before a motion without end is looked for. Reason: early iterations "
              "may look like anything");
}

}  // namespace voussoir
