// Accuracy and bounds of the nonlinear loop. None of them changes the solution beyond the tolerance.
#pragma once

namespace voussoir {

class ParameterSection;

struct NewtonParameters {
  double tolerance = 1e-8;        ///< [-] Karush-Kuhn-Tucker residual, relative to the largest force
  int largest_iterations = 2000;  ///< linear solves of one load step before it counts as not converged
  bool has_inertia = false;  ///< nothing moves freely: active sets may be tried; for who knows the step, not for scenes
  /// Time steps will start from the forces, which should be those in the middle of what equilibrium admits: no active
  /// sets at rest, whose forces lie at its rim. For who knows the run, not for scenes.
  bool time_follows = false;
  void declare(ParameterSection&);
};

}  // namespace voussoir
