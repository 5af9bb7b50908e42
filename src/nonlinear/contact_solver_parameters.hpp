// Order of the ways through the contact conditions (contact_solver.hpp), and how long each may take.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "nonlinear/active_set_parameters.hpp"
#include "nonlinear/interior_path_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct ContactSolverParameters {
  bool active_sets = true;  ///< active sets are tried first
  bool shortcut = true;     ///< active sets are tried again near the end of the path
  /// active sets that failed are left out of the load steps that follow, of twice as many after every failure
  bool back_off = true;
  int fast_solves = 30;    ///< linear solves of active sets
  int largest_path = 200;  ///< steps of the path, also in patches
  /// of the linear solve of a structure without contact points, where one solve is the answer: round-off
  static constexpr double finest_accuracy = 1e-12;
  /// of an equilibrium with strength that is held, from which points wear: statuses may be known, and what follows
  /// wears on
  static constexpr double held_accuracy = InteriorPathParameters::near;
  /// linear solves in pseudo-time before another path is tried, clearly more than active sets go round in: a structure
  /// that stones in flight have left is near a solution, from where the path is short
  static constexpr int closing_solves = static_cast<int>(order_of_magnitude) * ActiveSetParameters{}.patience;
  void declare(ParameterSection&);
};

}  // namespace voussoir
