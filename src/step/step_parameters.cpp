#include "step/step_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void StepParameters::declare(ParameterSection& section) {
  section.add("carry", carry,
              "motions of stones as wholes are taken out of the unknowns where round-off of them makes forces");
  section.add("error by indicator", error_by_indicator, "-", above(0.0),
              "times the indicator, the root of decreases, that the error is at most. Reason: measured 1 to 5 times "
              "(src/selection/README.md)");
  section.add(
      "too large", too_large, "-", above(0.0),
      "times what is allowed beyond which an indicator tells that the error is too large; where nothing is selected "
      "yet, 0.8 times. Reason: errors are 0.7 to 5 times the indicator, there 1.06 to 2 times");
  section.add("share of a time step", share_of_a_time_step, "-", above(0.0),
              "of the error tolerance that a time step may have. Reason: with all of it the shaken wall was up to "
              "2.2 % beside the solution with all points");
  section.add("least noise", least_noise, "-", above(0.0),
              "share of the largest force by which forces may be beside their bounds. Reason: round-off would tell, "
              "which differs with the number of ranks");
  section.add("proximal strain", proximal_strain, "-", above(0.0),
              "strain of a foundation that lets the structure move by its size: the proximal weight. Reason: far "
              "below the stiffness of any arch that stands, and bounds free motions");
  section.add("next to rigid", next_to_rigid, "-", above(0.0),
              "times the pressure below a column of them from which on stones are next to rigid. Reason: how far "
              "they move is geometry then");
  section.add(
      "steepest softening", steepest_softening, "-", inside(0.0, 1.0),
      "of the stiffness a point sees, with which a joint softens at most; brittle ones do. Reason: beyond 1 its "
      "force jumps, and no neighbourhood of an equilibrium is left");
  section.add("negligible turn", negligible_turn, "rad", above(0.0),
              "turn of stones that is followed no further. Reason: moves forces by this share of a stone; the next "
              "load step makes up for it");
}

}  // namespace voussoir
