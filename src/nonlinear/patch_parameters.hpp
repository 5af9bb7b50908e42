// Stones that are brought to rest alone: which, how many together, how; and those that slide on all they touch.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "homogenisation/coarse_operator_parameters.hpp"
#include "nonlinear/contact_solver_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct PatchParameters {
  bool used = true;  ///< stones that keep a load step from closing are brought to rest alone
  /// of all unknowns that patches may have together; half of it, that all that has parted may have to be one patch:
  /// beyond, their direct solutions cost more than they save, as those of the preconditioner
  double largest_share = CoarseOperatorParameters{}.largest_region;
  /// share of the residual beyond which a stone is stuck, and share of its tolerance that a patch aims at: with the
  /// right statuses a solve leaves a hundredth
  static constexpr double block_threshold = 1 / (order_of_magnitude * order_of_magnitude);
  /// share of the best residual above which a solve has left stuck stones: with the right ones it leaves a hundredth
  static constexpr double trigger = 1 / order_of_magnitude;
  /// share of the residual that a patch is solved to: the stones around it are farther from rest
  static constexpr double aim = block_threshold / order_of_magnitude;
  /// linear solves of active sets in a patch, and steps of the path: those of walls of 512 courses that arrive take up
  /// to 157, paths up to 142
  static constexpr int most_solves = ContactSolverParameters{}.largest_path;
  /// solves without a gain in a patch that is not at rest: half of those it has. Residuals of a stone that goes to its
  /// neighbour say nothing of how far that is
  static constexpr int patience = most_solves / 2;
  void declare(ParameterSection&);
};

}  // namespace voussoir
