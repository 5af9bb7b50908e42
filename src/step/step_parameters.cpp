#include "step/step_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void StepParameters::declare(ParameterSection& section) {
  section.add("carry", carry,
              "motions of stones as wholes are taken out of the unknowns where round-off of them makes forces");
  section.add(
      "share of violation", share_of_violation, "-", inside(0.0, 1.0),
      "of the largest violation to which a round is solved that releases points, and of the error tolerance that "
      "points which count as resting may make together. Reason: what is wrong beside is worth no more");
  section.add("coarsest tolerance", coarsest_tolerance, "-", inside(0.0, 1.0),
              std::string("of such a round. ") + no_reason);
  section.add(
      "first look", first_look, "-", inside(0.0, 1.0),
      "tolerance of the first round, whose violations show what to release, and of the linear solve of the estimate. "
      "Reason: with 1e-2 the estimate would depend on ranks by as much");
  section.add("error by indicator", error_by_indicator, "-", above(0.0),
              "times the indicator, the root of decreases, that the error is at most. Reason: measured 1 to 5 times "
              "(src/selection/README.md)");
  section.add("error of remainder", error_of_remainder, "-", above(0.0),
              "times what a release left that the error is then. Reason: measured 5 to 14 times");
  section.add("too large", too_large, "-", above(0.0),
              "times what is allowed beyond which an indicator tells that the error is too large. Reason: errors are "
              "0.7 to 5 times the indicator");
  section.add("too large bonded", too_large_bonded, "-", above(0.0),
              "the same where nothing is selected yet. Reason: errors are 1.06 to 2 times the indicator there");
  section.add("share of a time step", share_of_a_time_step, "-", above(0.0),
              "of the error tolerance that a time step may have. Reason: with all of it the shaken wall was up to "
              "2.2 % beside the solution with all points");
  section.add("solves with ties", solves_with_ties, "-", between(1, 1e6),
              "linear solves of a round with ties. Reason: those that arrive take up to 81");
  section.add("noise", noise, "-", above(0.0),
              std::string("times the tolerance below which violations are noise of the solver. ") + no_reason);
  section.add("least noise", least_noise, "-", above(0.0),
              "share of the largest force by which forces may be beside their bounds. Reason: round-off would tell, "
              "which differs with the number of ranks");
  section.add("proximal strain", proximal_strain, "-", above(0.0),
              "strain of a foundation that lets the structure move by its size: the proximal weight. Reason: far "
              "below the stiffness of any arch that stands, and bounds free motions");
  section.add("next to rigid", next_to_rigid, "-", above(0.0),
              "times the pressure below a column of them from which on stones are next to rigid. Reason: how far "
              "they move is geometry then");
  section.add("beyond mortar", beyond_mortar, "-", above(0.0),
              "times the stiffness of mortar that the local stiffness is at least. Reason: W(8) with mortar of 1e12 "
              "Pa/m takes 57 solves, 254 without both");
  section.add("beyond stone", beyond_stone, "-", above(0.0),
              "times the stiffness of stones that this may be at most. Reason: likewise");
  section.add(
      "steepest softening", steepest_softening, "-", inside(0.0, 1.0),
      "of the stiffness a point sees, with which a joint softens at most; brittle ones do. Reason: beyond 1 its "
      "force jumps, and no neighbourhood of an equilibrium is left");
  section.add("jump", jump, "-", inside(0.0, 1.0),
              "of its strength that a joint has lost beyond what its state asks for: cracks grew in a jump. Reason: no "
              "strength is known so well");
  section.add("negligible turn", negligible_turn, "rad", above(0.0),
              "turn of stones that is followed no further. Reason: moves forces by this share of a stone; the next "
              "load step makes up for it");
}

}  // namespace voussoir
