// Time steps, damping and mass of the stages that have a duration; velocities of blocks when time begins.
#pragma once

#include <string>
#include <vector>

#include "base/rotation_parameters.hpp"
#include "blocks/material_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct TimeParameters {
  Mass mass = Mass::consistent;
  double mass_damping = 0;         ///< [1/s] alpha of C = alpha M + beta K
  double stiffness_damping = 0;    ///< [s] beta
  double error_tolerance = 0.02;   ///< [-] of an automatic time step
  double force_tolerance = 1e-11;  ///< [-] of the forces of a time step, relative to the largest
  double largest_courant = 1000;   ///< [-] of an automatic time step
  int largest_halvings = 12;       ///< of one time step that does not converge
  void declare(ParameterSection&);
};

/// Velocity of a set of blocks when time begins: a translation and a rotation.
struct InitialVelocityParameters {
  std::string blocks = "all";
  double vx = 0, vy = 0, vz = 0;  ///< [m/s]
  RotationParameters turn;        ///< [rad/s] a middle stands for that of the mass of the blocks
  void declare(ParameterSection&);
  std::vector<KeyOfSpace> keys_of_space() const;
};

}  // namespace voussoir
