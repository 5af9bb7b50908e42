// Where time begins: what load steps have left is neither motion nor a gap.
#include "step/dynamic_step.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// A load step solved to 1e-3 of the largest force may leave the upper course of two as high above the lower one as that
// is worth, 6e-11 m, a thousand times what counts as round-off. It presses all the same, so it must not fall.
TEUCHOS_UNIT_TEST(DynamicStep, StonesThatPressAreClosedWhateverALoadStepHasLeftBetweenThem) {
  auto scene = wall_scene(2);
  scene.selection.mode = SelectionMode::all;
  scene.newton.tolerance = 1e-3;
  Experiment wall(scene);
  TEST_ASSERT(wall.advance({{"weight", 1}}));
  auto& state = wall.state();
  const auto& model = wall.model();
  const double left = scene.newton.tolerance * wall.solution().largest_force() / model.local_stiffness()[0];
  const auto& s = model.structure();
  for (const auto& block : s.blocks()) {
    double top = 0;
    for (const auto& x : block.mesh.position) top = std::max(top, x[1]);
    for (std::size_t i = 0; top > scene.mesh.wall.block_height * 1.5 && i < block.mesh.position.size(); ++i)
      state.displacement[2 * (block.first_local + i) + 1] += left;
  }

  constexpr double time_step = 1e-3;  // [s]
  DynamicStep<2> in_time(model);
  in_time.begin(state);
  in_time.set_time_step(time_step);
  const auto report = advance(in_time, state, {wall.load(), wall.prescribed()});
  TEST_ASSERT(report.step.newton.outcome == NewtonOutcome::converged);
  double fastest = 0;
  for (const double v : state.velocity) fastest = std::max(fastest, std::abs(v));
  out << "gap " << left << " m, velocity " << fastest << " m/s\n";
  TEST_COMPARE(fastest, <, 1e-3 * 9.81 * time_step);
}

}  // namespace
