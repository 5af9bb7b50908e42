// Brittle joints with few cells, as a run looks at them; coarse_joint itself: tests/unit/joints.
//
// Set-up    Beds of two cells of 0.125 m between one stone below and two on it, bent: stress goes linearly from s in
//           tension on the left to s in compression on the right. Points at edges bear 2/3 of what the edges do.
#include "range/coarse_joints.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double strength = 1e5;  // [Pa]

Warnings said_at(double share_of_strength, double fracture_energy = 0) {
  Scene scene = tied_wall();
  scene.joints[0].parameters.tension_strength = strength;
  scene.joints[0].parameters.fracture_energy = scene.joints[0].parameters.shear_fracture_energy = fracture_energy;
  Experiment wall(scene);
  const auto& model = wall.model();
  auto& state = wall.state();
  for (int k = 0; k < model.points().size(); ++k) {
    const auto& joint = joint_of(model, k);
    if (joint.block_i != 0) continue;
    const auto& p = model.points().points()[k];
    const double middle = joint.block_j == 1 ? 0.125 : 0.375;
    const double side = (model.structure().position()[p.shares_i.first()][0] - middle) / 0.125;  // -1, 0, 1
    state.lambda[2 * k] = 2.0 / 3 * side * share_of_strength * strength * p.area;
  }
  return CoarseJoints<2>(model).look(state, "a step");
}

TEUCHOS_UNIT_TEST(CoarseJoints, TellOfAFamilyOnceByHowMuchItsStrengthMayBeOverrated) {
  const auto said = said_at(0.9);
  TEST_EQUALITY(said.size(), 1);
  TEST_EQUALITY(said.front().what, "coarse_joint");
  TEST_EQUALITY(said.front().where, "scene > joints > dry");
  TEST_FLOATING_EQUALITY(said.front().how_much, 0.5, 1e-9);  // 1 / (2/3) - 1
  TEST_ASSERT(said.front().text.find("has 2 cells along it and comes to 60 % of its strength") != std::string::npos);
  TEST_ASSERT(said.front().text.find("that of 1 other of the family by less") != std::string::npos);
}

TEUCHOS_UNIT_TEST(CoarseJoints, SayNothingFarFromBreakingOrWhereJointsGiveWaySlowly) {
  TEST_ASSERT(said_at(0.1).empty());
  TEST_ASSERT(said_at(0.9, 1e9).empty());  // [J/m2] far more than stones hold: no joint breaks at once
}

}  // namespace
