// The smallest wall with a choice: one stone held at its base, two half stones on it side by side.
#pragma once

#include "homogenisation/merged_space.hpp"
#include "model/contact_problem.hpp"
#include "model/plane/plane_model.hpp"
#include "support/scenes.hpp"

namespace voussoir::test {

/// Block 0 below, 1 and 2 above it; 0 is held at its base. Nothing is selected.
inline Scene tied_wall() {
  Scene scene = wall_scene(2);
  scene.mesh.wall.blocks_per_course = 1;
  scene.selection.mode = SelectionMode::bonded;
  return scene;
}

/// Which local node copies are one.
inline std::vector<int> clusters(const PlaneModel& model, const std::vector<char>& selected) {
  return MergedSpace(model.structure(), model.points(), selected, model.held()).cluster();
}

inline ContactProblem::Parts parts_of(const PlaneModel& model, LinearSolver& solver) {
  const auto& how = model.settings();
  return {model.structure(),   model.points(),     model.continuum(), model.held(), model.local_stiffness(),
          model.initial_gap(), how.preconditioner, how.internals,     solver};
}

/// The blocks of a point.
inline const Joint& joint_of(const PlaneModel& model, int point) {
  return model.points().joints()[model.points().points()[point].joint];
}

}  // namespace voussoir::test
