// Numbers of the interior path (interior_path.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "nonlinear/active_set_parameters.hpp"
#include "statics/limit_analysis_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct InteriorPathParameters {
  bool used = true;              ///< the interior path follows where active sets fail, in patches too
  bool folds = true;             ///< friction follows the pressure by less where the path folds
  double to_boundary = 0.99;     ///< share of the step to the boundary that is taken, at most a full step
  double solve_accuracy = 1e-2;  ///< of linear solves
  int patience = 15;             ///< steps that gain too little, after which it folds or leads no further
  /// coefficient of friction beyond which it counts as this: larger numbers spoil the conditioning
  static constexpr double locking_friction = LimitAnalysisParameters::endless_friction;
  /// distance from the bounds at which the path begins, relative to the largest force: W(16), A(61), A(121) take 138
  /// solves, 148 with a hundredth, 152 with 1
  static constexpr double start = 1 / order_of_magnitude;
  /// bound on the resistance of a point at the start, relative to its local stiffness; it rises as the distance from
  /// the bounds falls: with the local stiffness itself A(121) takes half as many steps more; a hundred times lets
  /// forces at shared vertices grow
  static constexpr double resistance = order_of_magnitude;
  /// which that bound does not pass: joints as stiff as those of time steps, which the preconditioner sees
  static constexpr double largest_resistance = ActiveSetParameters{}.augmentation_in_time;
  /// least that a step leaves of the barrier, which aims at (1 - length of the last step)^2: Wright (1997); to a
  /// hundredth slacks get uneven
  static constexpr double least_share = 1 / order_of_magnitude;
  /// most that a step leaves of it: a short one, too, has to come nearer by as much as active sets call a gain
  static constexpr double largest_share = ActiveSetParameters{}.gained;
  /// share of the squared contact residual below which the barrier does not fall: it waits for residuals of a tenth
  static constexpr double waiting = 1 / (order_of_magnitude * order_of_magnitude);
  /// share of the proximal weights: holds loose stones, and is a hundredth of what bounds a collapse
  static constexpr double proximal = 1 / (order_of_magnitude * order_of_magnitude);
  /// share of the residual above which so many steps gained too little: they have not come nearer by a tenth of it
  static constexpr double gained = 1 - 1 / order_of_magnitude;
  /// equilibrium is near below this share of the contact residual
  static constexpr double balanced = 1 / order_of_magnitude;
  /// step below which the path folds, though equilibrium is near
  static constexpr double folded = 1 / order_of_magnitude;
  /// residual at which statuses may be known: active sets are offered the state
  static constexpr double near = 1 / (order_of_magnitude * order_of_magnitude * order_of_magnitude);
  /// by which residuals must fall before active sets are offered the state again
  static constexpr double nearer = 1 / order_of_magnitude;
  void declare(ParameterSection&);
};

}  // namespace voussoir
