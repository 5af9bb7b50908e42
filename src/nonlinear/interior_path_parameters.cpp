#include "nonlinear/interior_path_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void InteriorPathParameters::declare(ParameterSection& section) {
  section.add("used", used, "the interior path follows where active sets fail, in patches too");
  section.add("folds", folds,
              "friction follows the pressure by less where the path folds. Reason: no path of a convex problem folds");
  section.add("start", start, "-", inside(0.0, 1.0),
              "distance from the bounds at which the path begins, relative to the largest force. Reason: of W(16), "
              "A(61), A(121): 138 solves, 148 with 0.01, 152 with 1");
  section.add("to boundary", to_boundary, "-", inside(0.0, 1.0),
              "share of the step to the boundary that is taken, at most a full step. Reason: slacks stay positive: "
              "Wright (1997)");
  section.add("least share", least_share, "-", inside(0.0, 1.0),
              "least that a step leaves of the barrier. It aims at (1 - length of the last step)^2. Reason: Wright "
              "(1997); to a hundredth slacks get uneven");
  section.add("largest share", largest_share, "-", inside(0.0, 1.0),
              "most that it leaves. Reason: short steps, too, have to come nearer");
  section.add("waiting", waiting, "-", above(0.0),
              "share of the squared contact residual below which the barrier does not fall. Reason: the barrier "
              "waits for residuals");
  section.add("locking friction", locking_friction, "-", above(0.0),
              "coefficient of friction beyond which it counts as this. Reason: 89.4 degrees; larger numbers spoil "
              "the conditioning");
  section.add("proximal", proximal, "-", above(0.0),
              "share of the proximal weights. Reason: holds loose stones, and is a hundredth of what bounds a "
              "collapse");
  section.add("solve accuracy", solve_accuracy, "-", inside(0.0, 1.0),
              "of linear solves. Reason: 1e-3 takes as many solves and 1.6 times the Krylov iterations on the "
              "bridge; with 3e-2 the deformed bridge does not arrive");
  section.add(
      "resistance", resistance, "-", above(0.0),
      "bound on the resistance of a point at the start, relative to its local stiffness; it rises as the distance "
      "from the bounds falls. Reason: with the local stiffness itself A(121) takes half as many steps more; a hundred "
      "times lets forces "
      "at shared vertices grow");
  section.add(
      "largest resistance", largest_resistance, "-", above(0.0),
      "which that bound does not pass. Reason: the preconditioner sees joints a thousand times as stiff as stones");
  section.add("folded", folded, "-", inside(0.0, 1.0),
              std::string("step below which the path folds, though equilibrium is near. ") + no_reason);
  section.add("balanced", balanced, "-", above(0.0),
              std::string("equilibrium is near below this share of the contact residual. ") + no_reason);
  section.add("patience", patience, "-", between(1, 1e6),
              "steps that gain too little with equilibrium near, or are next to none, after which it leads no further. "
              "Reason: steps that cross a fold are short, and friction that follows by less needs some to show");
  section.add("gained", gained, "-", inside(0.0, 1.0),
              std::string("share of the residual above which they gained too little. ") + no_reason);
  section.add("halting", halting, "-", inside(0.0, 1.0),
              "step that is next to none. Reason: what bounds such steps shrinks with them");
  section.add("near", near, "-", above(0.0),
              std::string("residual at which statuses may be known: active sets are offered the state. ") + no_reason);
  section.add("nearer", nearer, "-", inside(0.0, 1.0),
              std::string("by which residuals must fall before they are offered it again. ") + no_reason);
}

}  // namespace voussoir
