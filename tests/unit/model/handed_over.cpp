// What belongs to another model, or is no number, is noticed at the door.
#include "model/handed_over.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TEUCHOS_UNIT_TEST(HandedOver, AStateIsOfTheModelAndFinite) {
  Scene scene = tied_wall();
  scene.joints[0].parameters.cohesion = 1e5;  // it can be lost: joints wear
  Experiment wall(scene);
  const auto initial = wall.step().initial_state();
  expect_state(wall.model(), initial);
  const std::vector<std::function<void(ContactState&)>> mistakes{
      [](ContactState& s) { s.displacement.pop_back(); },
      [](ContactState& s) { s.displacement.front() = no_number; },
      [](ContactState& s) { s.lambda.push_back(0); },
      [](ContactState& s) { s.lambda.front() = std::numeric_limits<double>::infinity(); },
      [](ContactState& s) { s.slip_origin.pop_back(); },
      [](ContactState& s) { s.selected.clear(); },
      [](ContactState& s) { s.status.pop_back(); },
      [](ContactState& s) { s.opened = s.slipped = {}; },
      [](ContactState& s) { s.slipped.pop_back(); },
      [](ContactState& s) { s.initial_gap.assign(1, 0.0); },
      [](ContactState& s) { s.velocity.assign(1, 0.0); },
      [](ContactState& s) { s.velocity.assign(s.displacement.size(), no_number); },
      [](ContactState& s) { s.acceleration.assign(1, 0.0); },
      [](ContactState& s) { s.largest_energy = -1; }};
  for (const auto& mistake : mistakes) {
    auto state = initial;
    mistake(state);
    TEST_THROW(expect_state(wall.model(), state), std::logic_error);
  }
}

TEUCHOS_UNIT_TEST(HandedOver, AStepIsTakenFromAStateAndLoadsOfItsModel) {
  Experiment wall(tied_wall());
  auto& step = wall.step();
  const auto state = step.initial_state();
  auto load = wall.load();
  const auto prescribed = wall.prescribed();
  TEST_ASSERT(step.take(state, {load, prescribed}).report.converged());
  load.front() = no_number;
  TEST_THROW(step.take(state, {load, prescribed}), std::logic_error);
  load.clear();
  TEST_THROW(step.take(state, {load, prescribed}), std::logic_error);
  auto other = state;
  other.lambda.pop_back();
  TEST_THROW(step.take(other, {wall.load(), prescribed}), std::logic_error);
}

}  // namespace
