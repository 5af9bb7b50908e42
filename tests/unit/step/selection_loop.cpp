// Which ties of the smallest wall are resolved, and where that leads.
//
// Set-up    One stone of 0.5 m on the ground, two of 0.25 m on it side by side, all 0.25 m high; block 2 is drawn to
//           the right on its free side. It weighs 1226 N, so that friction of 0.6 bears 736 N of that pull.
#include "step/selection_loop.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double weight = 2000 * 9.81 * 0.25 * 0.25;  // [N] of block 2
constexpr double face = 0.25;                         // [m2] on which it is drawn
constexpr double accuracy = 1e-6 * weight;            // a hundred times that of the solver

struct Drawn {
  Experiment wall;
  ContactState state;
  std::vector<double> mechanism;
  StepReport report;

  Drawn(SelectionMode mode, double pull) : wall(scene(mode, pull)), state(wall.state()) {
    std::vector<double> load, prescribed;
    model().loads({{"weight", 1.0}, {"pressure on right", 1.0}}, 0.0, load, prescribed);
    SelectionTools tools(model());
    Progress progress;
    SelectionLoop loop(tools, state, {load, prescribed}, progress);
    report = loop.run();
    mechanism = loop.mechanism();
  }
  static Scene scene(SelectionMode mode, double pull) {
    Scene scene = tied_wall();
    scene.selection.mode = mode;
    scene.loads.resize(1);  // own weight
    add_pressure(scene, "right", -pull / face);
    apply_all_loads(scene);
    return scene;
  }
  const PlaneModel& model() const { return wall.model(); }
  /// Over all points between two blocks and all ranks: force on the second [N], how many there are, how many selected.
  std::array<double, 4> between(BlockId i, BlockId j) const {
    std::array<double, 4> mine{}, all{};
    for (int k = 0; k < model().points().owned(); ++k) {
      const auto& joint = joint_of(model(), k);
      if (joint.block_i != i || joint.block_j != j) continue;
      const auto& axis = model().points().points()[k].axis;
      for (int c = 0; c < 2; ++c) mine[c] += state.lambda[2 * k] * axis[0][c] + state.lambda[2 * k + 1] * axis[1][c];
      mine[2] += 1;
      mine[3] += state.selected[k];
    }
    Teuchos::reduceAll(*model().structure().comm(), Teuchos::REDUCE_SUM, 4, mine.data(), all.data());
    return all;
  }
};

TEUCHOS_UNIT_TEST(SelectionLoop, ReleasesAJointThatPullsAndItsStoneStandsByItself) {
  const Drawn drawn(SelectionMode::adaptive, 100);
  TEST_ASSERT(drawn.report.converged());
  TEST_COMPARE(drawn.report.selection_rounds, >=, 1);
  const auto below = drawn.between(0, 2), beside = drawn.between(1, 2);
  TEST_EQUALITY(beside[3], beside[2]);  // all of its points are selected
  TEST_COMPARE(std::abs(beside[0]), <, accuracy);
  TEST_COMPARE(std::abs(below[0] + 100), <, accuracy);
  TEST_COMPARE(std::abs(below[1] + beside[1] - weight), <, accuracy);
}

TEUCHOS_UNIT_TEST(SelectionLoop, BondedNothingIsReleasedAndTheJointPulls) {
  const Drawn drawn(SelectionMode::bonded, 100);
  TEST_ASSERT(drawn.report.converged());
  TEST_EQUALITY(drawn.report.selection_rounds, 0);
  const auto below = drawn.between(0, 2), beside = drawn.between(1, 2);
  TEST_EQUALITY(beside[3] + below[3], 0);
  TEST_COMPARE(beside[0], <, -1);
  TEST_COMPARE(std::abs(below[0] + beside[0] + 100), <, accuracy);
  TEST_COMPARE(drawn.report.error_estimate, >, 0);
}

TEUCHOS_UNIT_TEST(SelectionLoop, WhatTiesAloneHeldSlidesAway) {
  const Drawn drawn(SelectionMode::adaptive, 1000);
  TEST_ASSERT(drawn.report.newton.outcome == NewtonOutcome::collapse);
  const auto& s = drawn.model().structure();
  double off = 0;  // from a motion of block 2 alone, by 1 to the right
  for (int n = 0; n < s.owned_nodes(); ++n) {
    const double right = s.blocks()[s.block_of_node()[n]].mesh.id == 2;
    off = std::max({off, std::abs(drawn.mechanism[2 * n] - right), std::abs(drawn.mechanism[2 * n + 1])});
  }
  TEST_COMPARE(largest_over_ranks(*s.comm(), off), <, 0.05);  // stones deform while one slides
}

}  // namespace
