// Numbers of the interior path (interior_path.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct InteriorPathParameters {
  bool used = true;                ///< the interior path follows where active sets fail, in patches too
  bool rising = true;              ///< points resist more once forces creep
  bool leaps = true;               ///< forces that drift evenly step after step go many steps at once
  bool folds = true;               ///< friction follows the pressure by less where the path folds
  double start = 0.1;              ///< distance from the bounds at which the path begins, relative to the largest force
  double to_boundary = 0.99;       ///< share of the step to the boundary that is taken
  double full_step = 0.999;        ///< share of a full step that is taken
  double long_step = 0.8;          ///< a step beyond this is long
  double middling_step = 0.4;      ///< a step beyond this is middling
  double after_long = 0.1;         ///< what is left of the barrier after a long step
  double after_middling = 0.3;     ///< the same after a middling one
  double after_short = 0.7;        ///< the same after a short one
  double waiting = 1e-2;           ///< share of the squared contact residual below which the barrier does not fall
  double locking_friction = 100;   ///< coefficient of friction beyond which it counts as this
  double proximal = 1e-2;          ///< share of the proximal weights
  double solve_accuracy = 1e-2;    ///< of linear solves
  int creeping_steps = 2;          ///< steps of waiting that gain too little: forces creep
  double creeping_gain = 0.5;      ///< share of the residual above which they gained too little
  double resistance = 10;          ///< largest resistance of a point at first, relative to its local stiffness
  double resistance_factor = 100;  ///< by which that rises where forces creep
  double largest_resistance = 1e3;  ///< from which on it rises no more
  double recentring = 1;            ///< times the contact residual from the bounds at which the path then begins anew
  double drift = 0.9;               ///< share of the last residual above which forces drift evenly
  double longest_leap = 100;        ///< steps that they go at once
  double folded = 0.1;              ///< step below which the path folds, though equilibrium is near
  /// share of the pressure that friction follows after the first fold; after the next: none
  double half_following = 0.5;
  double balanced = 0.1;  ///< equilibrium is near below this share of the contact residual
  int patience = 15;      ///< steps that gain too little, with equilibrium near, after which it leads no further
  double gained = 0.9;    ///< share of the residual above which they gained too little
  int halting_steps = 5;  ///< steps in a row that are next to none after which it leads nowhere
  double halting = 1e-6;  ///< step that is next to none
  double near = 1e-3;     ///< residual at which statuses may be known: active sets are offered the state
  double nearer = 0.1;    ///< by which residuals must fall before they are offered it again
  void declare(ParameterSection&);
};

}  // namespace voussoir
