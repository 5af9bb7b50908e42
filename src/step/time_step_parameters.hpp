// Numbers of a time step: what rests in it, and how velocities are found.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct TimeStepParameters {
  int largest_iterations = 250;       ///< linear solves of a time step
  double share_of_fastest = 1e-6;     ///< relative velocities below this share of the fastest rest
  double share_of_energy = 1e-9;      ///< and of the velocity that the energy of the structure could give it
  double share_of_tolerance = 0.15;   ///< of the error tolerance that points which count as resting may make together
  double left_by_solver = 10;         ///< times the tolerance by which gaps that load steps leave may press
  double no_force = 1e-8;             ///< share of the largest force below which a force is none
  double impulse_accuracy = 1e-10;    ///< of the solve that spreads an impact
  double velocity_accuracy = 1e-11;   ///< of the projection of velocities
  double velocity_round_off = 1e-14;  ///< of the largest velocity: what differences of velocities are known to
  double no_way = 1e-12;              ///< share of the energy of an impact below which nothing moves behind its points
  void declare(ParameterSection&);
};

}  // namespace voussoir
