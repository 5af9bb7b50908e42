// The order of the ways through the contact conditions, and what each of them may take.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct ContactSolverParameters {
  bool active_sets = true;  ///< active sets are tried first
  bool shortcut = true;     ///< active sets are tried again near the end of the path
  /// active sets that failed are left out of the load steps that follow, for longer after every failure
  bool back_off = true;
  int longest_wait = 7;        ///< solves that active sets are left out of at most
  int solves_in_time = 30;     ///< linear solves of active sets in a time step
  int solves_at_rest = 20;     ///< linear solves of active sets in a load step
  int solves_from_near = 40;   ///< linear solves of active sets from near the end of the path
  int patience_from_near = 3;  ///< solves without a gain after which they give up there
  int closing_solves = 80;     ///< linear solves of the augmented Lagrangian before another path is tried
  int most_doublings = 10;     ///< doublings of that number, one after every path that led nowhere
  int largest_path = 200;      ///< steps of the path
  void declare(ParameterSection&);
};

}  // namespace voussoir
