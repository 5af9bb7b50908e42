// An effect that a scene does not name costs nothing and changes nothing; one that it names does both.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "blocks/stresses.hpp"
#include "linalg/reduce.hpp"
#include "model/loads_at_work.hpp"
#include "results/effect_costs.hpp"
#include "scene/scene_effects.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A wall of 3 x 3 stones under its own weight.
Scene plain() {
  Scene scene = wall_scene(3);
  scene.loads.resize(1);
  apply_all_loads(scene);
  return scene;
}

/// One load of every type that adds something to the wall.
std::vector<LoadKind> every_kind() {
  SelfWeightParameters weight;
  AccelerationParameters push;
  push.ax = 0.5;
  TractionParameters wind;
  wind.on = "left";
  wind.tx = 100;
  SettlementParameters sink;
  sink.support = "base";
  sink.uy = -1e-3;
  PointLoadParameters statue;
  statue.x = 0.5;
  statue.y = 0.75;
  statue.fy = -1e3;
  CrowdParameters crowd;
  crowd.on = "top";
  GroundMotionParameters quake;
  quake.ax = 0.5;
  MovingTrainParameters train;
  train.on = "top";
  train.axle_load = {1e3};
  train.behind = {0};
  train.position = 0.7;
  EarthPressureParameters soil;
  soil.on = "left";
  soil.surface = 0.5;
  WaterPressureParameters water;
  water.on = "left";
  water.level = 0.5;
  BuoyancyParameters lift;
  lift.level = 0.5;
  TemperatureParameters heat;
  heat.change = 20;
  return {weight, push, wind, sink, statue, crowd, quake, train, soil, water, lift, heat};
}

Scene with(const LoadKind& kind, double factor) {
  Scene scene = plain();
  LoadParameters load;
  load.name = "tested";
  load.kind = kind;
  scene.loads.push_back(load);
  scene.stages.back().factors["tested"] = factor;
  return scene;
}

TEUCHOS_UNIT_TEST(Effects, AreAllTried) { TEST_EQUALITY(every_kind().size(), load_words().size()); }

TEUCHOS_UNIT_TEST(Effects, CostNothingAndChangeNothingWhereASceneDoesNotNameThem) {
  Experiment without(plain());
  TEST_ASSERT(without.run());
  const auto bare = without.solution();
  const auto unnamed = effect_costs(without.scene(), without.model());
  TEST_EQUALITY(unnamed.at("self weight").calls > 0, true);
  for (const auto& kind : every_kind()) {
    LoadParameters load;
    load.kind = kind;
    const auto word = load.word();
    out << word << "\n";
    if (word != "self weight") {
      TEST_EQUALITY(unnamed.at(word).in_play, false);
      TEST_EQUALITY(unnamed.at(word).bytes, 0);
      TEST_EQUALITY(unnamed.at(word).calls, 0);
      TEST_EQUALITY(unnamed.at(word).seconds, 0.0);
    }
    // Named, but with factor 0: the very same numbers, to the last bit.
    Experiment idle(with(kind, 0.0));
    TEST_ASSERT(idle.run());
    TEST_EQUALITY(difference(idle.solution(), bare), 0.0);
    // At work: it has bytes, it is called, and the wall feels it.
    Experiment at_work(with(kind, 1.0));
    TEST_ASSERT(at_work.run());
    const auto cost = effect_costs(at_work.scene(), at_work.model()).at(word);
    TEST_EQUALITY(cost.in_play, true);
    TEST_COMPARE(cost.bytes, >, word == "self weight" ? unnamed.at(word).bytes : 0);
    TEST_COMPARE(cost.calls, >, word == "self weight" ? unnamed.at(word).calls : 0);
    // Of the largest displacement: far above the 1e-8 of Newton.
    TEST_COMPARE(difference(at_work.solution(), bare), >, 1e-6);
  }
}

TEUCHOS_UNIT_TEST(Effects, OfJointsAreAbsentWhereNoFamilyHasThem) {
  Scene scene = plain();
  const auto in_play = [&](const std::string& name) {
    for (const auto& e : effects_of(scene))
      if (e.name == name) return e.in_play();
    return false;
  };
  TEST_ASSERT(in_play("friction") && !in_play("cohesion") && !in_play("tension strength"));
  scene.joints[0].parameters.friction_coefficient = 0;
  scene.joints[0].parameters.cohesion = 1e5;
  TEST_ASSERT(!in_play("friction") && in_play("cohesion"));
}

TEUCHOS_UNIT_TEST(Effects, WhereNothingRubsNoSlipIsRemembered) {
  Scene scene = plain();
  scene.mesh.wall.blocks_per_course = 1;  // a column stands without friction
  for (const double friction : {0.0, 0.6}) {
    scene.joints[0].parameters.friction_coefficient = friction;
    Experiment column(scene);
    TEST_ASSERT(column.run());
    TEST_EQUALITY(column.state().slip_origin.size(), friction > 0 ? column.state().lambda.size() : 0);
    const auto bytes = effect_costs(column.scene(), column.model()).at("friction").bytes;
    // Per point of all ranks, ghosts too, its coefficient and its slip, a vector.
    const double points = total_over_ranks(*column.model().structure().comm(), column.model().points().size());
    TEST_EQUALITY(bytes, friction > 0 ? 24 * static_cast<long long>(points) : 0LL);
    TEST_EQUALITY(effect_costs(column.scene(), column.model()).at("cohesion").bytes, 0LL);
    double shear = 0;
    for (const auto& p : column.solution().points) shear = std::max(shear, std::abs(p.tangential_force));
    if (friction == 0) TEST_EQUALITY(shear, 0.0);
  }
}

TEUCHOS_UNIT_TEST(Effects, OfTimeAreAbsentFromLoadStepsAndHoldNothing) {
  Scene scene = plain();
  Experiment still(scene);
  for (const char* name : {"inertia", "damping", "initial velocities", "construction"}) {
    const auto cost = effect_costs(still.scene(), still.model()).at(name);
    TEST_ASSERT(!cost.in_play);
    TEST_EQUALITY(cost.bytes, 0);
  }
  scene.stages.back().duration = 1;
  Experiment shaken(scene);
  const auto inertia = effect_costs(shaken.scene(), shaken.model()).at("inertia");
  TEST_ASSERT(inertia.in_play);
  // Two matrices of at least a diagonal of 12 bytes a number.
  TEST_COMPARE(inertia.bytes, >, 2 * 12 * 2 * shaken.model().structure().total_nodes());
}

/// Largest stress that differs from (xx, yy, 0) [Pa].
double stress_error(Experiment& e, double xx, double yy) {
  const auto inner = e.model().loads_at_work().inner_loads({{"heat", 1.0}}, 0.0, e.model().structure());
  const auto stress = cell_stresses(e.model().structure(), e.state().displacement, inner);
  double wrong = 0;
  for (std::size_t i = 0; i < stress.size(); i += 3)
    wrong = std::max({wrong, std::abs(stress[i] - xx), std::abs(stress[i + 1] - yy), std::abs(stress[i + 2])});
  return wrong;
}

/// A wall that is only heated, by 40 K, held at the bottom (y) and the left (x), all joints bonded.
Scene heated(Plane plane) {
  Scene scene = wall_scene(3);
  scene.model.plane = plane;
  scene.supports.clear();
  scene.selection.mode = SelectionMode::bonded;
  scene.newton.tolerance = 1e-13;
  add_support(scene, "base", "y");
  add_support(scene, "left", "x");
  scene.loads.resize(1);
  TemperatureParameters heat;
  heat.change = 40;
  heat.expansion = 1e-5;
  scene.loads[0].name = "heat";
  scene.loads[0].kind = heat;
  apply_all_loads(scene);
  return scene;
}

// 40 K times 1e-5 / K times 10 GPa: 4 MPa is what a held stone would bear. Solves stop at 1e-10 of their right-hand
// side, so that a free wall is free to 4e6 Pa x 1e-8, with a hundred to spare for the sum over a cell.
constexpr double held_stress = 4e6, tolerance = held_stress * 1e-8;

TEUCHOS_UNIT_TEST(Temperature, OfAWallThatIsFreeGivesNoStress) {
  for (const auto plane : {Plane::stress, Plane::strain}) {
    Experiment wall(heated(plane));
    TEST_ASSERT(wall.run());
    TEST_COMPARE(stress_error(wall, 0, 0), <, tolerance);
    double highest = 0;  // 0.75 m high
    for (const double u : wall.state().displacement) highest = std::max(highest, u);
    TEST_COMPARE(highest, >, 0.75 * 4e-4 * 0.999);
  }
}

TEUCHOS_UNIT_TEST(Temperature, OfAWallBetweenTwoPlanesGivesYoungsModulusTimesTheFreeStrain) {
  Scene scene = heated(Plane::stress);
  add_support(scene, "right", "x");
  Experiment wall(scene);
  TEST_ASSERT(wall.run());
  TEST_COMPARE(stress_error(wall, -held_stress, 0), <, tolerance);
}

TEUCHOS_UNIT_TEST(Temperature, OfAWallThatIsHeldAllRoundGivesMoreByPoissonsRatio) {
  Scene scene = heated(Plane::stress);
  add_support(scene, "right", "x");
  add_support(scene, "top", "y");
  Experiment wall(scene);
  TEST_ASSERT(wall.run());
  const double both = -held_stress / (1 - 0.2);
  TEST_COMPARE(stress_error(wall, both, both), <, tolerance);
}

}  // namespace
