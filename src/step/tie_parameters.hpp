// Stones that nothing but ties holds: how much they may owe to them, and how their balance is looked for.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct TieParameters {
  double noise = 10;            ///< times the tolerance below which what a block lacks is nothing
  double balanced = 1e-10;      ///< share of their magnitudes below which loads of a stone are in balance
  double largest_share = 0.03;  ///< of the load of a stone that ties may bear beyond the law where all stones move
  double largest_share_alone = 1e-3;  ///< the same of a stone alone between its neighbours
  double share_of_step = 0.5;         ///< of the step to balance that stones take
  double momentum = 0.85;             ///< share of its last way that a stone rolls on
  int patience = 50;                  ///< sweeps without progress after which no balance is found
  double progress = 0.999;            ///< share of what all stones lack below which a sweep is progress
  /// stiffness under a stone that no point touches in some direction, relative to its points
  double foundation = 1e-3;
  int steps_alone = 200;  ///< steps of a stone alone
  void declare(ParameterSection&);
};

}  // namespace voussoir
