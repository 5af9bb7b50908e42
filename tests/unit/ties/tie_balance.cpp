// What stones owe to ties, by hand: a stone that stands owes nothing, one that hangs all of its weight, one that slides
// what friction does not bear.
//
// Set-up    One stone of 0.5 m on the ground, two of 0.25 m on it side by side, all 0.25 m high and tied.
#include "ties/tie_balance.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "step/selection_loop.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double weight = 2000 * 9.81 * 0.25 * 0.25;  // [N] of blocks 1 and 2
constexpr double friction = 0.6, face = 0.25;         // [m2] on which block 2 is drawn

/// The equilibrium of the tied wall under a gravity and a pull on block 2, judged.
struct Judged {
  Experiment wall;
  TieBalance balance;

  Judged(double gravity, double pull) : wall(scene(gravity, pull)) {
    if (!wall.run()) return;
    const auto& model = wall.model();
    const auto& state = wall.state();
    TieCriterion ties(model);
    balance = ties.judge(model.law(), state, clusters(model, state.selected),
                         borne_by_joints(model.structure(), state.displacement, wall.load()), wall.load(),
                         largest_normal_force(model, state.lambda));
  }
  static Scene scene(double gravity, double pull) {
    Scene scene = tied_wall();
    scene.loads.resize(1);
    std::get<SelfWeightParameters>(scene.loads[0].kind).gravity = gravity;
    if (pull > 0) add_pressure(scene, "right", -pull / face);
    apply_all_loads(scene);
    return scene;
  }
  bool loose(BlockId block) const {
    const auto& blocks = wall.model().structure().blocks();
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (blocks[b].mesh.id == block) return !balance.loose.empty() && balance.loose[b] != 0;
    return false;
  }
  /// Whether this rank knows the block.
  bool here(BlockId block) const { return wall.model().structure().local_block(block) >= 0; }
};

TEUCHOS_UNIT_TEST(TieCriterion, StonesThatStandOnOthersOweNothing) {
  const Judged standing(9.81, 0);
  TEST_ASSERT(!standing.balance.any);
  TEST_EQUALITY(standing.balance.where, -1);
}

TEUCHOS_UNIT_TEST(TieCriterion, StonesThatHangOweAllTheyWeigh) {
  const Judged hanging(-9.81, 0);
  TEST_ASSERT(hanging.balance.any);
  TEST_FLOATING_EQUALITY(hanging.balance.largest, 1.0, 0.05);  // beside each other they press a little as well
  TEST_EQUALITY(hanging.balance.where, 1);
  for (const BlockId b : {1, 2})
    if (hanging.here(b)) TEST_ASSERT(hanging.loose(b));
  if (hanging.here(0)) TEST_ASSERT(!hanging.loose(0));  // a support holds it
}

// No force of the joint below comes nearer to a pull P and the weight W than the cone of friction: (P - mu W) over
// root(1 + mu^2). That is the least that ties can be owed, and what stones are moved by must not hide it.
TEUCHOS_UNIT_TEST(TieCriterion, AStoneThatSlidesOwesWhatFrictionDoesNotBear) {
  TEST_ASSERT(!Judged(9.81, 500).balance.any);  // of 736 N
  const Judged sliding(9.81, 1000);
  TEST_ASSERT(sliding.balance.any);
  TEST_EQUALITY(sliding.balance.where, 2);
  const double least = (1000 - friction * weight) / std::hypot(1.0, friction) / std::hypot(1000.0, weight);
  TEST_COMPARE(sliding.balance.largest, >=, least * (1 - 1e-6));
  TEST_COMPARE(sliding.balance.largest, <=, 1.0);
  if (sliding.here(1)) TEST_ASSERT(!sliding.loose(1));
}

}  // namespace
