// Accuracy and bounds of the nonlinear loop. None of them changes the solution beyond the tolerance.
#pragma once

namespace voussoir {

class ParameterSection;

struct NewtonParameters {
  double tolerance = 1e-8;      ///< [-] Karush-Kuhn-Tucker residual, relative to the largest force
  int largest_iterations = 2000; ///< linear solves of one load step before it counts as not converged
  // Of the fast way, chosen by who knows the kind of step, not by scenes.
  int fast_solves = 8;           ///< linear solves after which it gives up
  double fast_augmentation = 1;  ///< relative to the local stiffness
  void declare(ParameterSection&);
};

}  // namespace voussoir
