// Numbers of the active sets: semismooth Newton with Coulomb's coupling (active_set.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"

namespace voussoir {

class ParameterSection;

struct ActiveSetParameters {
  double augmentation_in_time = 1000;  ///< resistance of closed points in time, relative to their local stiffness
  double accuracy = 1e-4;              ///< of linear solves, relative to their right side
  int patience = 8;                    ///< solves that gain too little after which it circles
  double alike = 0.01;                 ///< share of a change by which one that goes round may differ from the last
  double gained = 0.5;                 ///< share of the best residual below which a solve has gained
  /// Krylov iterations of a solve at rest, at most; such a one without a gain means loose stones
  int many_krylov = 50;
  int many_krylov_in_space = 500;  ///< the same of stones in space
  /// resistance of points that give way once a stone is lost, relative to their local stiffness, and the most in
  /// patches; 0: none
  double damping = 5e-3;
  /// resistance of closed points in load steps: as many solves as with that in time, and fewer Krylov iterations
  double augmentation_at_rest() const { return augmentation_in_time / order_of_magnitude; }
  /// the same where statuses stay and all is in balance: gaps that the last solve leaves decide on statuses at the
  /// start of the next step
  double augmentation_once_settled() const { return augmentation_in_time * order_of_magnitude; }
  /// of linear solves in time where statuses stay: round-off of stiff systems
  static constexpr double finest_accuracy = 1e-10;
  /// growth of the residual that means a lost stone, and most that bringing stones to rest alone may leave: statuses
  /// that change without a flight move the residual less
  static constexpr double lost = order_of_magnitude;
  void declare(ParameterSection&);
};

}  // namespace voussoir
