// How the steps of a model are solved: what a scene says of it, a struct for each method.
//
// A model has its own, and that of a time step other ones than the model at rest. Steps, ties and time are given these
// and see no scene.
#pragma once

#include <vector>

#include "blocks/material_parameters.hpp"
#include "dynamics/time_parameters.hpp"
#include "homogenisation/preconditioner_parameters.hpp"
#include "linalg/solver_parameters.hpp"
#include "nonlinear/newton_parameters.hpp"
#include "scene/internals.hpp"
#include "scene/named.hpp"
#include "selection/selection_parameters.hpp"

namespace voussoir {

struct Scene;

struct ModelSettings {
  explicit ModelSettings(const Scene&);
  /// Of one time step of the model at rest that these are for.
  /// @param tolerance  of Newton
  ModelSettings of_time_step(double tolerance) const;

  Rotations rotations;
  SelectionParameters selection;
  NewtonParameters newton;
  PreconditionerParameters preconditioner;
  SolverParameters solver;
  TimeParameters time;
  std::vector<Named<InitialVelocityParameters>> velocities;  ///< as time begins
  Internals internals;
  bool any_time;  ///< some stage has a duration
  bool builds;    ///< stones appear or disappear between stages
};

}  // namespace voussoir
