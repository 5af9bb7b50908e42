// Stones of space between springs with a law, and what they owe to ties, by hand.
//
// Set-up    A prism of 1 x 0.6 x 2 m on a ground that is held, its bed of nine points a metre below its middle.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "step/selection_loop.hpp"
#include "support/wall_in_space.hpp"
#include "ties/stone_relaxation.hpp"
#include "ties/tie_balance.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double mu = 0.6, spring = 1e6, ground = 1e12;  // [N/m] of points and of what holds the ground

TEUCHOS_UNIT_TEST(StoneInSpace, MovesTurnsAndTakesMomentsAsARigidBody) {
  const Vector<3> arm{1, -2, 0.5}, force{3, 4, -1};
  const StoneVector<3> motion{0.1, 0.2, 0.3, -1, 2, 0.5};
  TEST_COMPARE(norm(motion_at(arm, motion) - (Vector<3>{0.1, 0.2, 0.3} + cross(Vector<3>{-1, 2, 0.5}, arm))), <=,
               1e-15);
  const auto at = wrench(arm, force);
  // The work of a force is that of force and moment.
  double work = 0;
  for (int c = 0; c < 6; ++c) work += at[c] * motion[c];
  TEST_FLOATING_EQUALITY(work, dot(force, motion_at(arm, motion)), 1e-14);
  // Taken about the end of the arm it has no moment.
  const auto there = about(at, Vector<3>{}, arm);
  TEST_COMPARE(norm(Vector<3>{there[3], there[4], there[5]}), <=, 1e-14);
  TEST_FLOATING_EQUALITY(size_of(at, 1e9), norm(force), 1e-14);
  TEST_FLOATING_EQUALITY(size_of(at, 1e-9), norm(cross(arm, force)) * 1e9, 1e-14);
}

/// The prism lacks what it is given; its points press with so much each at first.
struct Between {
  ExperimentInSpace wall{wall_in_space_scene(prism())};
  StoneRelaxation<3> stones{wall.model(), bodies(wall.model()), spring};

  static std::vector<Stone<3>> bodies(const SpaceModel& model) {
    const auto& s = model.structure();
    std::vector<Stone<3>> bodies;
    for (const auto& block : s.blocks()) {
      Stone<3> stone;
      for (const auto& x : block.mesh.position) stone.middle = stone.middle + (1.0 / block.nodes) * x;
      for (const auto& x : block.mesh.position) stone.radius = std::max(stone.radius, norm(x - stone.middle));
      if (block.mesh.id == 0) stone.support = {ground, ground, ground, ground, ground, ground};
      bodies.push_back(stone);
    }
    return bodies;
  }
  /// What the prism lacks alone where it lacks least [N]; over all ranks.
  double alone(const StoneVector<3>& lack, double pressed, double bearable) {
    const auto& s = wall.model().structure();
    std::vector<StonePoint<3>> points(wall.model().points().size());
    for (auto& p : points) p = {{mu, 0, 0}, {pressed, 0, 0}, 0};
    stones.begin(points, std::vector<StoneVector<3>>(s.owned_blocks(), StoneVector<3>{}));
    const int b = s.local_block(1);
    const bool mine = b >= 0 && b < s.owned_blocks();
    return largest_over_ranks(*s.comm(), mine ? stones.alone(b, lack, bearable) : 0.0);
  }
};

constexpr double little = 1;  // [N]

TEUCHOS_UNIT_TEST(StonesInSpace, AStoneThatIsPressedFindsBalanceAndOneThatIsLiftedNone) {
  Between prism;
  TEST_COMPARE(prism.alone({0, 0, -1000, 0, 0, 0}, 0, little), <=, little);
  TEST_FLOATING_EQUALITY(prism.alone({0, 0, 1000, 0, 0, 0}, 0, little), 1000.0, 1e-12);
}

// Nine points of 1000 N bear 5400 N of friction in whatever direction, and the moment of a push at the bed; what twists
// the prism about its axis is borne by friction as well, at most mu N by the mean lever of the points, 0.35 m.
TEUCHOS_UNIT_TEST(StonesInSpace, FrictionBearsAPushInEveryDirectionAndATwist) {
  Between prism;
  for (const double angle : {0.0, 0.4, 0.8, 1.5}) {
    const auto pushed = [&](double force) {
      return wrench(Vector<3>{0, 0, -1}, Vector<3>{force * std::cos(angle), force * std::sin(angle), 0});
    };
    TEST_COMPARE(prism.alone(pushed(4000), 1000, little), <=, little);
    TEST_COMPARE(prism.alone(pushed(8000), 1000, little), >, 1000);
  }
  TEST_COMPARE(prism.alone({0, 0, 0, 0, 0, 1000}, 1000, little), <=, little);
  TEST_COMPARE(prism.alone({0, 0, 0, 0, 0, 5000}, 1000, little), >, little);
}

// A moment about x has the lever 0.3 m of the thickness, one about y half a metre: 9000 N bear 2700 and 4500 N m.
TEUCHOS_UNIT_TEST(StonesInSpace, AStoneTipsOverTheEdgeThatIsNearer) {
  Between prism;
  TEST_COMPARE(prism.alone({0, 0, 0, 2000, 0, 0}, 1000, little), <=, little);
  TEST_COMPARE(prism.alone({0, 0, 0, 3500, 0, 0}, 1000, little), >, little);
  TEST_COMPARE(prism.alone({0, 0, 0, 0, 3500, 0}, 1000, little), <=, little);
  TEST_COMPARE(prism.alone({0, 0, 0, 0, 6000, 0}, 1000, little), >, little);
}

/// The prism tied to the ground under its weight and a push, judged.
TieBalance judged(double gravity, const Vector<3>& push) {
  auto scene = wall_in_space_scene(prism(), push);
  scene.selection.mode = SelectionMode::bonded;
  std::get<SelfWeightParameters>(scene.loads[0].kind).gravity = gravity;
  ExperimentInSpace wall(scene);
  if (!wall.advance({{"weight", 1.0}, {"push", 1.0}}).converged()) return {};
  const auto& model = wall.model();
  TieCriterion ties(model);
  const auto cluster = MergedSpace(model.structure(), model.points(), wall.state().selected, model.held()).cluster();
  return ties.judge(model.law(), wall.state(), cluster,
                    borne_by_joints(model.structure(), wall.state().displacement, wall.load()), wall.load(),
                    largest_normal_force(model, wall.state().lambda));
}

TEUCHOS_UNIT_TEST(TiesInSpace, HoldNoStoneThatStandsAndAllOfOneThatHangs) {
  TEST_ASSERT(!judged(9.81, {0, 0, 0}).any);
  const auto hanging = judged(-9.81, {0, 0, 0});
  TEST_ASSERT(hanging.any);
  TEST_EQUALITY(hanging.where, 1);
  TEST_FLOATING_EQUALITY(hanging.largest, 1.0, 1e-6);
}

// It tips over an edge when pushed by half of its weight along x, by 0.3 along y.
TEUCHOS_UNIT_TEST(TiesInSpace, FindAStoneThatTipsInWhateverDirection) {
  for (const double share : {0.9, 1.1}) {
    TEST_EQUALITY(judged(9.81, {0.5 * share * 9.81, 0, 0}).any, share > 1);
    TEST_EQUALITY(judged(9.81, {0, 0.3 * share * 9.81, 0}).any, share > 1);
  }
}

}  // namespace
