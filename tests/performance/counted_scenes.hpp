// Scenes whose linear solves are counted, and their rows of solve_counts.csv.
#pragma once

#include <Teuchos_FancyOStream.hpp>
#include <string>

#include "run/simulation.hpp"
#include "support/scenes.hpp"

namespace voussoir::test {

/// The same scene with points that are selected as needed.
inline Scene adaptive(Scene scene) {
  scene.selection.mode = SelectionMode::adaptive;
  return scene;
}

/// An adaptive wall of blocks with 2 x 1 cells.
inline Scene wall_of_few_cells(int courses) {
  Scene scene = adaptive(wall_scene(courses));
  scene.mesh.wall.cells_along = 2;
  scene.mesh.wall.cells_up = 1;
  return scene;
}

/// A scene of two loads, its weight and one more, applied one after the other.
class TwoSteps {
 public:
  TwoSteps(const Scene& scene, Teuchos::FancyOStream& out) : experiment_(scene), out_(out) {}

  bool weight() { return experiment_.advance({{name(0), 1}}); }
  bool second() { return experiment_.advance({{name(0), 1}, {name(1), 1}}); }
  StepReport last() const { return experiment_.solution().last; }
  /// Whether the last step costs what the table says.
  bool as_in_table(const std::string& row) const;

 private:
  std::string name(int load) const { return experiment_.scene().loads[load].name; }

  Experiment experiment_;
  Teuchos::FancyOStream& out_;
};

/// Runs a scene to its end in the folder of that name. False unless it ends in equilibrium and costs what the row of
/// that name says.
bool whole_run(const std::string& row, const Scene&, Teuchos::FancyOStream& out, RunSummary&);

}  // namespace voussoir::test
