// Stones that nothing but ties holds: how much they may owe to them, and how their balance is looked for.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"

namespace voussoir {

class ParameterSection;

struct TieParameters {
  double largest_share = 0.03;  ///< of the load of a stone that ties may bear beyond the law where all stones move
  double largest_share_alone = 1e-3;  ///< the same of a stone alone between its neighbours
  double momentum = 0.85;             ///< share of its last way that a stone rolls on
  int patience = 50;  ///< sweeps without progress after which no balance is found, or more in large structures
  /// share of their magnitudes below which loads of a stone are in balance: sums of nodal forces of either sign round
  /// to 1e-15 of their magnitudes
  static constexpr double balanced = 1e-10;
  /// of the step to balance that stones take: what Jacobi's method bears between two springs
  static constexpr double share_of_step = 0.5;
  /// stiffness under a stone that no point touches in some direction, relative to its points: the matrix of its step is
  /// regular, and what resists is far stiffer
  static constexpr double foundation = 1 / (order_of_magnitude * order_of_magnitude * order_of_magnitude);
  /// share of what all stones lack below which a sweep is progress: by less than a thousandth a sweep nothing would
  /// come within the patience
  static constexpr double progress = 1 - foundation;
  /// steps of a stone alone: those that stand take some dozens at most
  static constexpr int steps_alone = 200;
  void declare(ParameterSection&);
};

}  // namespace voussoir
