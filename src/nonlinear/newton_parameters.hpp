// Accuracy and bounds of the nonlinear loop. None of them changes the solution beyond the tolerance.
#pragma once

namespace voussoir {

class ParameterSection;

struct NewtonParameters {
  double tolerance = 1e-8;      ///< [-] Karush-Kuhn-Tucker residual, relative to the largest force
  int largest_iterations = 2000; ///< linear solves of one load step before it counts as not converged
  bool has_inertia = false;  ///< nothing moves freely: active sets may be tried; for who knows the step, not for scenes
  void declare(ParameterSection&);
};

}  // namespace voussoir
