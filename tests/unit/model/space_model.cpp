// What a model of space makes of a scene: weight and reactions, points, mass, waves, velocities, and steps with it.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "support/wall_in_space.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

WallInSpaceParameters small_wall() {
  WallInSpaceParameters p;
  p.courses = 3;
  p.blocks_per_course = 2;
  p.ground_height = 0.25;
  return p;
}

constexpr double weight_of_prism = 1 * 0.6 * 2 * 2000 * 9.81;

TEUCHOS_UNIT_TEST(SpaceModel, PointsSeeYoungsModulusTimesTheSideOfACell) {
  auto wall = prism();
  wall.cells_along = 4;  // cells of 0.25 x 0.3 x 1 m; the ground has 0.25 x 0.3 x 0.5 m
  const ExperimentInSpace experiment(wall_in_space_scene(wall));
  const double above = 10e9 * std::cbrt(0.25 * 0.3 * 1), below = 10e9 * std::cbrt(0.25 * 0.3 * 0.5);
  for (const double k : experiment.model().local_stiffness())
    TEST_FLOATING_EQUALITY(k, 2 * above * below / (above + below), 1e-13);
}

TEUCHOS_UNIT_TEST(SpaceModel, WavesPassTheShortestEdgeOfACell) {
  const ExperimentInSpace experiment(wall_in_space_scene(prism()));
  // E (1 - nu) / ((1 + nu) (1 - 2 nu)) = 1.1111 E at nu = 0.2; edges of 0.5, 0.3 and 1 m.
  const double speed = std::sqrt(10e9 * 0.8 / (1.2 * 0.6) / 2000);
  for (int b = 0; b < experiment.model().structure().local_blocks(); ++b) {
    TEST_FLOATING_EQUALITY(experiment.model().wave_speed(b), speed, 1e-14);
    TEST_FLOATING_EQUALITY(experiment.model().passage(b), 0.3 / speed, 1e-14);
  }
}

// Both of them fly and turn about the axis through their mass centre, which lies at (0.5, 0.3).
TEUCHOS_UNIT_TEST(SpaceModel, VelocitiesAtTheStartAreThoseOfTheScene) {
  auto scene = wall_in_space_scene(prism());
  InitialVelocityParameters given;
  given.vx = 1;
  given.vy = 2;
  given.vz = 3;
  given.turn.rotation = 4;
  scene.velocities.push_back({"spin", given});
  const ExperimentInSpace experiment(scene);
  const auto v = experiment.model().initial_velocities();
  const auto& s = experiment.model().structure();
  for (int i = 0; i < s.nodes(); ++i) {
    const auto arm = s.position()[i] - Vector<3>{0.5, 0.3, 0};
    const auto expected = Vector<3>{1, 2, 3} + cross(Vector<3>{0, 0, 4}, arm);
    TEST_COMPARE(norm(Vector<3>{v[3 * i], v[3 * i + 1], v[3 * i + 2]} - expected), <=, 1e-13);
  }
}

TEUCHOS_UNIT_TEST(SpaceModel, MassIsThatOfTheBlocks) {
  const ExperimentInSpace experiment(wall_in_space_scene(prism()));
  const auto& s = experiment.model().structure();
  const auto mass = experiment.model().mass();
  std::vector<double> along(3 * s.nodes(), 0.0), weight;
  for (int i = 0; i < s.nodes(); ++i) along[3 * i + 1] = 1;
  mass->apply_stiffness(along, weight);
  double sum = 0;
  for (int i = 0; i < s.owned_nodes(); ++i) sum += weight[3 * i + 1];
  TEST_FLOATING_EQUALITY(total_over_ranks(*s.comm(), sum), (2 + 0.5) * 0.6 * 2000, 1e-13);
}

// Weight is borne to what a step is solved to, lawfully, bonded or not; adaptive selection lets go of what it may.
TEUCHOS_UNIT_TEST(StepsInSpace, BearOwnWeightAndAPush) {
  const double weight = (2 * 0.5 * 0.25 * 0.25 * 4) * 2000 * 9.81;  // with the ground
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    auto scene = wall_in_space_scene(small_wall(), {1.0, 0.5, 0});
    scene.selection.mode = mode;
    ExperimentInSpace wall(scene);
    TEST_ASSERT(wall.advance({{"weight", 1.0}}).converged());
    TEST_COMPARE(norm(wall.reaction() - Vector<3>{0, 0, weight}), <=, 1e-8 * weight);
    TEST_ASSERT(wall.advance({{"weight", 1.0}, {"push", 1.0}}).converged());
    const Vector<3> pushed{-weight / 9.81, -0.5 * weight / 9.81, weight};
    TEST_COMPARE(norm(wall.reaction() - pushed), <=, 1e-8 * weight);
    const auto [largest, beyond] = wall.forces(0.6);
    TEST_COMPARE(largest, >, 0);
    if (mode == SelectionMode::all) TEST_COMPARE(beyond, <=, 1e-10 * largest);
  }
}

// Pushed along y it tips over its long edge, at 0.3 of its weight.
TEUCHOS_UNIT_TEST(StepsInSpace, APrismStandsOrTips) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    auto scene = wall_in_space_scene(prism(), {0, 0.3 * 9.81, 0});
    scene.selection.mode = mode;
    ExperimentInSpace wall(scene);
    TEST_ASSERT(wall.advance({{"weight", 1.0}}).converged());
    TEST_ASSERT(wall.advance({{"weight", 1.0}, {"push", 0.9}}).converged());
    TEST_COMPARE(std::abs(wall.reaction()[1] + 0.27 * 2.5 / 2 * weight_of_prism), <=, 1e-8 * weight_of_prism);
    TEST_ASSERT(wall.advance({{"weight", 1.0}, {"push", 1.1}}).newton.outcome == NewtonOutcome::collapse);
  }
}

}  // namespace
