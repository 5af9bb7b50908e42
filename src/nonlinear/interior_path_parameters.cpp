#include "nonlinear/interior_path_parameters.hpp"

#include "base/parameter_section.hpp"

namespace voussoir {

void InteriorPathParameters::declare(ParameterSection& section) {
  section.add("used", used, "the interior path follows where active sets fail, in patches too");
  section.add("rising", rising, "points resist more once forces creep");
  section.add("leaps", leaps, "forces that drift evenly step after step go many steps at once");
  section.add("folds", folds,
              "friction follows the pressure by less where the path folds. Reason: no path of a convex problem folds");
  section.add("start", start, "-", inside(0.0, 1.0),
              "distance from the bounds at which the path begins, relative to the largest force. Reason: of W(16), "
              "A(61), A(121): 138 solves; 0.01 took 148, 1 took 152");
  section.add("to boundary", to_boundary, "-", inside(0.0, 1.0),
              "share of the step to the boundary that is taken. Reason: slacks stay positive: Wright (1997)");
  section.add("full step", full_step, "-", inside(0.0, 1.0),
              "share of a full step that is taken. Reason: slacks stay positive");
  section.add("long step", long_step, "-", inside(0.0, 1.0), std::string("a step beyond this is long. ") + no_reason);
  section.add("middling step", middling_step, "-", inside(0.0, 1.0),
              std::string("a step beyond this is middling. ") + no_reason);
  section.add("after long", after_long, "-", inside(0.0, 1.0),
              std::string("what is left of the barrier after a long step. ") + no_reason);
  section.add("after middling", after_middling, "-", inside(0.0, 1.0),
              std::string("the same after a middling one. ") + no_reason);
  section.add("after short", after_short, "-", inside(0.0, 1.0),
              std::string("the same after a short one. ") + no_reason);
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
  section.add("creeping steps", creeping_steps, "-", between(1, 1e6),
              std::string("steps of waiting that gain too little: forces creep. ") + no_reason);
  section.add("creeping gain", creeping_gain, "-", inside(0.0, 1.0),
              std::string("share of the residual above which they gained too little. ") + no_reason);
  section.add("resistance", resistance, "-", above(0.0),
              std::string("largest resistance of a point at first, relative to its local stiffness. ") + no_reason);
  section.add("resistance factor", resistance_factor, "-", above(1.0),
              std::string("by which that rises where forces creep. ") + no_reason);
  section.add("largest resistance", largest_resistance, "-", above(0.0),
              std::string("from which on it rises no more. ") + no_reason);
  section.add("recentring", recentring, "-", above(0.0),
              std::string("times the contact residual from the bounds at which the path then begins "
                          "anew. ") +
                  no_reason);
  section.add("drift", drift, "-", inside(0.0, 1.0),
              std::string("share of the last residual above which forces drift evenly. ") + no_reason);
  section.add("longest leap", longest_leap, "-", at_least(1.0),
              std::string("steps that they go at once. ") + no_reason);
  section.add("folded", folded, "-", inside(0.0, 1.0),
              std::string("step below which the path folds, though equilibrium is near. ") + no_reason);
  section.add("half following", half_following, "-", inside(0.0, 1.0),
              "share of the pressure that friction follows after the first fold; after the next: none. Reason: "
              "folds.md");
  section.add("balanced", balanced, "-", above(0.0),
              std::string("equilibrium is near below this share of the contact residual. ") + no_reason);
  section.add("patience", patience, "-", between(1, 1e6),
              std::string("steps that gain too little, with equilibrium near, after which it leads no "
                          "further. ") +
                  no_reason);
  section.add("gained", gained, "-", inside(0.0, 1.0),
              std::string("share of the residual above which they gained too little. ") + no_reason);
  section.add("halting steps", halting_steps, "-", between(1, 1e6),
              std::string("steps in a row that are next to none after which it leads nowhere. ") + no_reason);
  section.add("halting", halting, "-", inside(0.0, 1.0),
              "step that is next to none. Reason: what bounds such steps shrinks with them");
  section.add("near", near, "-", above(0.0),
              std::string("residual at which statuses may be known: active sets are offered the state. ") + no_reason);
  section.add("nearer", nearer, "-", inside(0.0, 1.0),
              std::string("by which residuals must fall before they are offered it again. ") + no_reason);
}

}  // namespace voussoir
