// Numbers of the interior path (interior_path.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct InteriorPathParameters {
  bool used = true;               ///< the interior path follows where active sets fail, in patches too
  bool folds = true;              ///< friction follows the pressure by less where the path folds
  double start = 0.1;             ///< distance from the bounds at which the path begins, relative to the largest force
  double to_boundary = 0.99;      ///< share of the step to the boundary that is taken, at most a full step
  double least_share = 0.1;       ///< least that a step leaves of the barrier
  double largest_share = 0.7;     ///< most that it leaves
  double waiting = 1e-2;          ///< share of the squared contact residual below which the barrier does not fall
  double locking_friction = 100;  ///< coefficient of friction beyond which it counts as this
  double proximal = 1e-2;         ///< share of the proximal weights
  double solve_accuracy = 1e-2;   ///< of linear solves
  double resistance = 10;         ///< bound on the resistance of a point at the start, relative to its local stiffness
  double largest_resistance = 1000;  ///< which that bound does not pass as the barrier falls
  double folded = 0.1;               ///< step below which the path folds, though equilibrium is near
  double balanced = 0.1;             ///< equilibrium is near below this share of the contact residual
  int patience = 15;      ///< steps that gain too little, or are next to none, after which it leads no further
  double gained = 0.9;    ///< share of the residual above which they gained too little
  double halting = 1e-6;  ///< step that is next to none
  double near = 1e-3;     ///< residual at which statuses may be known: active sets are offered the state
  double nearer = 0.1;    ///< by which residuals must fall before they are offered it again
  void declare(ParameterSection&);
};

}  // namespace voussoir
