// Where time begins: what load steps have left is neither motion nor a gap.
#include "time/dynamic_step.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "linalg/reduce.hpp"
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
  DynamicStep in_time(model);
  in_time.begin(state);
  in_time.set_time_step(time_step);
  const auto report = advance(in_time, state, {wall.load(), wall.prescribed()});
  TEST_ASSERT(report.step.newton.outcome == NewtonOutcome::converged);
  double fastest = 0;
  for (const double v : state.velocity) fastest = std::max(fastest, std::abs(v));
  out << "gap " << left << " m, velocity " << fastest << " m/s\n";
  TEST_COMPARE(fastest, <, 1e-3 * 9.81 * time_step);
}

double fastest_of(const ContactState& state) {
  double fastest = 0;
  for (const double v : state.velocity) fastest = std::max(fastest, std::abs(v));
  return fastest;
}

/// Two courses, one stone wide, on soft mortar.
Scene column_on_mortar(double stiffness) {
  Scene scene = wall_scene(2);
  scene.mesh.wall.blocks_per_course = 1;
  scene.materials[0].parameters.poisson_ratio = 0;
  scene.selection.mode = SelectionMode::all;
  scene.joints[0].parameters.normal_stiffness = scene.joints[0].parameters.tangential_stiffness = stiffness;
  return scene;
}

// Beds that give way by the weight on them press on as they did: they are no stones in each other, to be thrown apart.
TEUCHOS_UNIT_TEST(DynamicStep, WhatStandsOnMortarStandsInTime) {
  for (const double push : {0.0, 0.5}) {
    Experiment wall(column_on_mortar(1e8));
    TEST_ASSERT(wall.advance({{"weight", 1}, {"sideways", push}}));
    auto state = wall.state();
    const auto before = state.lambda;
    constexpr double time_step = 1e-3;  // [s]
    DynamicStep in_time(wall.model());
    in_time.begin(state);
    in_time.set_time_step(time_step);
    for (int k = 0; k < 3; ++k) {
      const auto report = advance(in_time, state, {wall.load(), wall.prescribed()});
      TEST_ASSERT(report.step.newton.outcome == NewtonOutcome::converged);
    }
    TEST_COMPARE(fastest_of(state), <, 1e-5 * 9.81 * time_step);  // load steps are solved to 1e-8 of the largest force
    for (std::size_t i = 0; i < before.size(); ++i)
      TEST_COMPARE(std::abs(state.lambda[i] - before[i]), <, 1e-5 * 9.81 * 2000);
  }
}

// A mass on a spring: more load at once swings it to twice the way, in half a period.
TEUCHOS_UNIT_TEST(DynamicStep, MortarSwingsAsASpring) {
  constexpr double stiffness = 1e7, height = 0.25, more = 0.1;  // [Pa/m], [m]; stones give way by a thousandth
  Experiment wall(column_on_mortar(stiffness));
  TEST_ASSERT(wall.advance({{"weight", 1}}));
  auto state = wall.state();
  const auto start = state.displacement;
  auto load = wall.load();
  for (double& f : load) f *= 1 + more;
  const double period = 2 * M_PI * std::sqrt(2000 * height / stiffness);
  constexpr int steps = 100;
  DynamicStep in_time(wall.model());
  in_time.begin(state);
  in_time.set_time_step(period / steps);
  std::vector<double> way;
  for (int k = 0; k < steps; ++k) {
    TEST_ASSERT(advance(in_time, state, {load, wall.prescribed()}).step.converged());
    double farthest = 0;
    for (std::size_t i = 1; i < start.size(); i += 2) farthest = std::max(farthest, start[i] - state.displacement[i]);
    way.push_back(largest_over_ranks(*wall.model().structure().comm(), farthest));
  }
  const double sinks = more * 2000 * 9.81 * height / stiffness;
  TEST_FLOATING_EQUALITY(way[steps / 2 - 1], 2 * sinks, 0.01);
  TEST_FLOATING_EQUALITY(way[steps / 4 - 1], sinks, 0.03);
  TEST_COMPARE(way.back(), <, 0.01 * sinks);
}

// Of stones that are not there nobody weighs anything, and nothing rests on them.
TEUCHOS_UNIT_TEST(DynamicStep, StonesThatAreNotThereHoldNothing) {
  Scene scene = wall_scene(3);
  scene.mesh.wall.blocks_per_course = 1;
  scene.stages[1].name = "later";
  scene.construction = {{"top", {"course 2", "later", ""}}};
  Experiment wall(scene);
  TEST_ASSERT(wall.advance("weight", {{"weight", 1}}));
  auto& state = wall.state();
  auto up = wall.load();
  for (double& f : up) f *= -1;
  DynamicStep in_time(wall.model());
  const auto& mesh = scene.mesh.wall;
  TEST_FLOATING_EQUALITY(in_time.total_mass(), 2 * 2000 * mesh.block_height * mesh.block_length, 1e-9);
  in_time.begin(state);
  constexpr double time_step = 1e-3;  // [s]
  in_time.set_time_step(time_step);
  for (int k = 0; k < 10; ++k) TEST_ASSERT(advance(in_time, state, {up, wall.prescribed()}).step.converged());
  // The course that is there falls upwards, off the one that is held.
  const double speed = largest_over_ranks(*wall.model().structure().comm(), fastest_of(state));
  TEST_FLOATING_EQUALITY(speed, 9.81 * 10 * time_step, 0.05);
}

}  // namespace
