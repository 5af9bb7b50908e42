// Stones that are brought to rest alone: which, how many together, how; and those that slide on all they touch.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct PatchParameters {
  bool used = true;          ///< stones that keep a load step from closing are brought to rest alone
  bool loose_stones = true;  ///< stones of patches that slide on all they touch are moved to where a point holds them
  double trigger = 0.05;     ///< share of the best residual above which a solve has left stuck stones
  double block_threshold = 1e-2;        ///< share of the residual beyond which a stone is stuck
  double aim_of_residual = 1e-3;        ///< share of the residual that a patch is solved to
  double aim_of_tolerance = 0.1;        ///< share of the tolerance that a patch is solved to at most
  double bearable_rise = 10;            ///< times the residual that patches may raise it to
  double largest_share = 0.25;          ///< of all unknowns that patches may have together
  double largest_share_of_all = 0.125;  ///< of all unknowns that may be parted to be one patch; 0: never
  int more_rings = 3;                   ///< rings of neighbours that a patch which passes on too much may gain
  int active_solves = 200;              ///< solves of active sets in a patch
  double active_aim = 1e-2;             ///< share of the tolerance that they aim at
  int patience = 100;                   ///< solves without a gain in a patch without border
  int patience_with_border = 10;        ///< the same in other patches
  int largest_path = 200;               ///< steps of the path in a patch
  double held_share = 1e-10;  ///< share of its stiffness that moving a stone as a whole takes where it is held
  double parallel = 1e-9;     ///< beds are parallel, and a stone comes nearer to another, up to and beyond this
  void declare(ParameterSection&);
};

}  // namespace voussoir
