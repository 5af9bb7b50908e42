// What a run writes down of the places that a scene observes.
#include "results/observations.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "base/error.hpp"
#include "linalg/reduce.hpp"
#include "results/support_reactions.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;
using Place = ObservationParameters::Place;

/// A wall of 3 x 3 stones observed at one place.
Scene observed(const std::string& name, const ObservationParameters& place) {
  Scene scene = wall_scene(3);
  scene.observations = {{name, place}};
  return scene;
}

Observations observations(const Experiment& e) { return {e.scene(), e.model()}; }

/// u = a linear field of the place, on every local node copy.
std::vector<double> linear_field(const Experiment& e, double a, double b, double c) {
  std::vector<double> u;
  for (const auto& x : e.model().structure().position()) {
    u.push_back(a + b * x[0]);
    u.push_back(c * x[1]);
  }
  return u;
}

TEUCHOS_UNIT_TEST(Observations, HoldNothingAndSayNothingWhereASceneObservesNothing) {
  const Experiment wall(wall_scene(3));
  const auto none = observations(wall);
  TEST_ASSERT(none.columns().empty());
  TEST_ASSERT(none.values({{}, {}, {}, {}}).empty());
}

TEUCHOS_UNIT_TEST(Observations, TheNearestNodeMovesAsTheFieldThere) {
  ObservationParameters corner;
  corner.x = 1e-3;
  corner.y = -2e-3;  // the node is the corner of the wall, (0, 0)
  const Experiment wall(observed("corner", corner));
  const auto at = observations(wall);
  TEST_EQUALITY(at.columns().size(), 2);
  TEST_EQUALITY(at.columns()[0], "ux_m of corner");
  TEST_EQUALITY(at.columns()[1], "uy_m of corner");
  const auto u = at.values({linear_field(wall, 0.5, 0.25, 2.0), {}, {}, {}});
  TEST_EQUALITY(u[0], 0.5);  // one node with weight 1: the very number
  TEST_EQUALITY(u[1], 0.0);
}

TEUCHOS_UNIT_TEST(Observations, TheMeanOfALinearFieldIsItsValueAtTheMassCentre) {
  ObservationParameters all;
  all.place = Place::mean;
  const Experiment wall(observed("wall", all));
  double width = 0, height = 0;
  for (const auto& x : wall.solution().position) {
    width = std::max(width, x[0]);
    height = std::max(height, x[1]);
  }
  const auto u = observations(wall).values({linear_field(wall, 0.5, 0.25, 2.0), {}, {}, {}});
  // Sums of some hundred products: 1e-12 is far above their round-off and the order in which ranks add them up.
  TEST_FLOATING_EQUALITY(u[0], 0.5 + 0.25 * width / 2, 1e-12);
  TEST_FLOATING_EQUALITY(u[1], 2.0 * height / 2, 1e-12);
}

TEUCHOS_UNIT_TEST(Observations, VelocitiesAreColumnsOfScenesInTimeAndNoNumbersInLoadSteps) {
  ObservationParameters corner;
  auto scene = observed("corner", corner);
  scene.stages.back().duration = 1.0;
  const Experiment wall(scene);
  const auto at = observations(wall);
  TEST_EQUALITY(at.columns().size(), 4);
  TEST_EQUALITY(at.columns()[2], "vx_m_per_s of corner");
  const auto field = linear_field(wall, 0.5, 0, 0);
  auto values = at.values({field, linear_field(wall, -3.0, 0, 0), {}, {}});
  TEST_EQUALITY(values[0], 0.5);
  TEST_EQUALITY(values[2], -3.0);
  values = at.values({field, {}, {}, {}});
  TEST_EQUALITY(values[0], 0.5);
  TEST_ASSERT(std::isnan(values[2]) && std::isnan(values[3]));
}

TEUCHOS_UNIT_TEST(Observations, ASupportShowsItsMotionAndTheForceItBears) {
  ObservationParameters under;
  under.place = Place::support;
  auto scene = wall_scene(3);
  under.support = scene.supports.front().name;
  scene.observations = {{"ground", under}};
  const Experiment wall(scene);
  const auto at = observations(wall);
  TEST_ASSERT(at.ask_reactions());
  TEST_EQUALITY(at.columns().size(), 4);
  TEST_EQUALITY(at.columns()[2], "fx_N of ground");
  const auto forces = linear_field(wall, 3.0, 0, 0);  // 3 N along x at every node copy
  const auto values = at.values({linear_field(wall, 0.25, 0, 1.0), {}, forces, {}});
  TEST_FLOATING_EQUALITY(values[0], 0.25, 1e-12);
  const auto nodes = held_nodes(wall.scene().supports, wall.model());
  const double mine = static_cast<double>(nodes.front().size());
  const double all = total_over_ranks(*wall.model().structure().comm(), mine);
  TEST_ASSERT(all > 0);
  TEST_FLOATING_EQUALITY(values[2], 3.0 * all, 1e-12);
  TEST_EQUALITY(values[3], 0.0);
}

TEUCHOS_UNIT_TEST(Observations, APlaceFarFromEveryNodeOfItsBlocksIsRefused) {
  ObservationParameters far;
  far.x = -7;
  const Experiment wall(observed("kite", far));
  std::string message;
  try {
    observations(wall);
  } catch (const InputError& error) {
    message = error.what();
  }
  for (const char* piece : {"observations > kite > tolerance = 0.05 [m]", "7 m away", "larger tolerance"})
    TEST_ASSERT(message.find(piece) != std::string::npos);
}

}  // namespace
