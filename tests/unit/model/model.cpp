// What a model makes of a scene's supports and loads.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// A node in two supports is moved by the first that holds it, not by both: the values are written, not computed,
// so they are compared to the last bit.
TEUCHOS_UNIT_TEST(Model, ANodeOfTwoSupportsMovesOnce) {
  Scene scene = arch_scene(5);
  scene.supports.push_back({"again", {"springing right", "x"}});
  LoadParameters load = scene.loads.back();
  load.name = "again";
  load_as<SettlementParameters>(load)->support = "again";
  scene.loads.push_back(load);
  const Experiment experiment(scene);
  std::vector<double> force, prescribed;
  experiment.model().loads({{"spreading", 1.0}, {"again", 1.0}}, 0.0, force, prescribed);
  TEST_EQUALITY(*std::max_element(prescribed.begin(), prescribed.end()), 0.005);
  experiment.model().loads({{"again", 1.0}}, 0.0, force, prescribed);
  TEST_EQUALITY(*std::max_element(prescribed.begin(), prescribed.end()), 0.0);
}

// Two stones stand side by side on the ground, which holds the foot of the joint between them on both sides: no force
// there changes anything, so there is none, bit for bit. Once it grew by a tenth with every time step, and with it the
// force that tolerances refer to.
TEUCHOS_UNIT_TEST(Model, WhereSupportsHoldBothSidesOfAJointThereIsNoForce) {
  Experiment experiment(wall_scene(4));
  for (const double push : {0.0, 0.5, 1.0}) TEST_ASSERT(experiment.advance({{"weight", 1.0}, {"sideways", push}}));
  int held = 0;
  const auto solution = experiment.solution();
  for (const auto& p : solution.points)
    if (solution.held[p.node_i][0] && solution.held[p.node_j][0]) {
      ++held;
      TEST_EQUALITY(p.normal_force, 0);
    }
  TEST_EQUALITY(held, 3);  // between the four stones of the first course
}

}  // namespace
