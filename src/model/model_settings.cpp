#include "model/model_settings.hpp"

#include <algorithm>

#include "dynamics/load_steps.hpp"
#include "scene/scene.hpp"

namespace voussoir {

ModelSettings::ModelSettings(const Scene& scene)
    : rotations(scene.model.rotations),
      selection(scene.selection),
      newton(scene.newton),
      preconditioner(scene.preconditioner),
      solver(scene.solver),
      time(scene.time),
      velocities(scene.velocities),
      internals(scene.internals),
      any_time(voussoir::any_time(scene.stages)),
      builds(!scene.construction.empty()) {}

ModelSettings ModelSettings::of_time_step(double tolerance) const {
  auto settings = *this;
  settings.newton.tolerance = tolerance;
  settings.newton.has_inertia = true;
  settings.newton.largest_iterations =
      std::min(settings.newton.largest_iterations, settings.internals.time_step.largest_iterations);
  return settings;
}

}  // namespace voussoir
