// Stones that are brought to rest alone: which, how many together, how; and those that slide on all they touch.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct PatchParameters {
  bool used = true;       ///< stones that keep a load step from closing are brought to rest alone
  double trigger = 0.05;  ///< share of the best residual above which a solve has left stuck stones
  double block_threshold =
      1e-2;           ///< share of the residual beyond which a stone is stuck; of a patch's tolerance, its aim
  double aim = 1e-3;  ///< share of the residual that a patch is solved to
  double largest_share = 0.25;  ///< of all unknowns that patches may have together
  int more_rings = 3;           ///< rings of neighbours that a patch which passes on too much may gain
  int most_solves = 200;        ///< linear solves of active sets in a patch, and steps of the path
  int patience = 100;           ///< solves without a gain in a patch without border
  void declare(ParameterSection&);
};

}  // namespace voussoir
