// Mortar that holds up to its strength, and is gone for good beyond it.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double gravity = 9.81, density = 2000;  // [m/s2, kg/m3]

Scene two_stones(double width, double height, double angle) {
  Scene scene = gmsh_scene(repository("/tests/hard/geo/two_stones.geo"), 0.25, CellType::quadrilateral);
  scene.mesh.gmsh.geometry = {{"width", width}, {"height", height}, {"angle", angle}};
  return scene;
}

/// The lower of two stones of 1 m x 1 m hangs from the upper one; without Poisson's effect the joint carries
/// density x gravity x 1 m everywhere.
Experiment hanging(double strength_of_weight, double friction, SelectionMode mode) {
  Scene scene = two_stones(1, 1, 0);
  scene.selection.mode = mode;
  scene.selection.error_tolerance = 0;
  scene.materials[0].parameters.poisson_ratio = 0;
  auto& law = scene.joints[0].parameters;
  law.friction_coefficient = friction;
  law.tension_strength = strength_of_weight * density * gravity;
  law.cohesion = law.tension_strength;
  add_support(scene, "top", "xy");
  add_gravity(scene, 0, -gravity);
  apply_all_loads(scene);
  return Experiment(scene);
}

// Within a percent: the traction is uniform to round-off, so the threshold is sharp.
TEUCHOS_UNIT_TEST(Brittle, AStoneHangsByItsMortarUpToItsTensileStrength) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    auto holds = hanging(1.01, 0.6, mode);
    TEST_ASSERT(holds.run());
    double carried = 0;
    const auto s = holds.solution();
    for (const auto& p : s.points) {
      carried -= p.normal_force;
      TEST_ASSERT(!p.broken && std::abs(p.gap) < 1e-12);
    }
    TEST_FLOATING_EQUALITY(carried, density * gravity, 1e-7);
  }
}

// One percent too much is far below an error of one percent in the energy, so an adaptive run has to release all.
TEUCHOS_UNIT_TEST(Brittle, AStoneFallsWhenItsWeightExceedsTheTensileStrength) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    auto falls = hanging(0.99, 0.6, mode);
    TEST_ASSERT(!falls.run());
    const auto last = falls.solution().last;
    out << last.newton.reason << "\n";
    TEST_ASSERT(last.newton.outcome == NewtonOutcome::collapse);
  }
}

/// A flat stone, 4 m x 0.25 m, on an incline; the lower one is held. Cohesion in multiples of what it takes to hold:
/// density gravity height (sin - mu cos).
Experiment on_incline(double share, double angle, double friction, SelectionMode mode) {
  const double a = angle * M_PI / 180;
  Scene scene = two_stones(4, 0.25, angle);
  scene.selection.mode = mode;
  auto& law = scene.joints[0].parameters;
  law.friction_coefficient = friction;
  law.cohesion = share * density * gravity * 0.25 * (std::sin(a) - friction * std::cos(a));
  law.tension_strength = law.cohesion;
  add_support(scene, "bottom", "xy");
  add_gravity(scene, 0, -gravity);
  apply_all_loads(scene);
  return Experiment(scene);
}

// Shear is not uniform: at the ends of the joint it is larger, and mortar that fails there fails for good. Twice the
// mean is more than enough, half of it is not.
TEUCHOS_UNIT_TEST(Brittle, CohesionHoldsAStoneOnASteepIncline) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    auto holds = on_incline(2, 40, 0.6, mode);  // tan 40 degrees = 0.84 > 0.6
    TEST_ASSERT(holds.run());
    const auto s = holds.solution();
    double along = 0;
    for (const auto& p : s.points) along += std::abs(p.tangential_force);
    TEST_FLOATING_EQUALITY(along, density * gravity * std::sin(40 * M_PI / 180), 1e-6);
    TEST_ASSERT(!on_incline(0.5, 40, 0.6, mode).run());
  }
}

// Too flat to slide: friction alone.
TEUCHOS_UNIT_TEST(Brittle, FrictionAloneHoldsAStoneOnAFlatIncline) {
  auto dry = on_incline(0, 30, 0.6, SelectionMode::all);  // tan 30 degrees = 0.577 < 0.6
  TEST_ASSERT(dry.run());
  TEST_ASSERT(!on_incline(0, 32, 0.6, SelectionMode::all).run());  // tan 32 degrees = 0.625
}

// What broke stays broken: under half its weight again, the stone falls that would have hung by sound mortar.
TEUCHOS_UNIT_TEST(Brittle, BrokenMortarDoesNotHeal) {
  Scene scene = two_stones(1, 1, 0);
  scene.materials[0].parameters.poisson_ratio = 0;
  auto& law = scene.joints[0].parameters;
  law.tension_strength = law.cohesion = 0.75 * density * gravity;
  add_support(scene, "top", "xy");
  add_support(scene, "bottom", "xy");
  add_gravity(scene, 0, -gravity);
  LoadParameters apart;
  apart.name = "apart";
  auto& settlement = apart.kind.emplace<SettlementParameters>();
  settlement.support = "bottom";
  settlement.uy = -1e-4;  // [m] 0.5 MPa of tension between the stones, far beyond the strength of 15 kPa
  scene.loads.push_back(apart);
  apply_all_loads(scene);
  Experiment experiment(scene);
  TEST_ASSERT(experiment.advance({{"gravity", 0.1}}));
  for (const auto& p : experiment.solution().points) TEST_ASSERT(!p.broken);
  TEST_ASSERT(experiment.advance({{"gravity", 0.1}, {"apart", 1}}));
  for (const auto& p : experiment.solution().points) TEST_ASSERT(p.broken && p.gap > 5e-5 && p.normal_force == 0);
  TEST_ASSERT(experiment.advance({{"gravity", 0.1}, {"apart", 0.01}}));  // the gap remains: no force comes back
  for (const auto& p : experiment.solution().points) TEST_ASSERT(p.broken && p.normal_force >= 0);
}

}  // namespace
