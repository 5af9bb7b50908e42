// Numbers of a time step: what rests in it, and how velocities are found.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "nonlinear/contact_solver_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct TimeStepParameters {
  double velocity_accuracy = 1e-11;  ///< of the projection of velocities
  /// of the largest velocity: what differences of velocities are known to, some tens of roundings; the system of their
  /// projection is singular at vertices of three blocks
  static constexpr double velocity_round_off = 1e-14;
  /// share of the energy of an impact below which nothing moves behind its points: velocities known to 1e-6 of it
  static constexpr double no_way = 1e-12;
  /// linear solves of a time step: active sets before and after one path; half the step is the way out then
  static constexpr int largest_iterations =
      2 * ContactSolverParameters{}.fast_solves + ContactSolverParameters{}.largest_path;
  /// relative velocities below this share of the fastest rest: what their differences lose to round-off and solver
  static constexpr double share_of_fastest = 1e-6;
  /// and of the velocity that the energy of the structure could give it: round-off of displacements, by a step
  static constexpr double share_of_energy = 1e-9;
  void declare(ParameterSection&);
};

}  // namespace voussoir
