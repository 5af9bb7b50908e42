// Time steps, damping and mass of the stages that have a duration; velocities of blocks when time begins.
#pragma once

#include <limits>
#include <string>

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
  double rotation = 0;            ///< [rad/s] counter-clockwise; in space about an axis along z
  /// Stands for a coordinate of the mass centre of the blocks.
  static constexpr double mass_centre = std::numeric_limits<double>::infinity();
  double about_x = mass_centre, about_y = mass_centre;  ///< [m]
  void declare(ParameterSection&);
};

}  // namespace voussoir
