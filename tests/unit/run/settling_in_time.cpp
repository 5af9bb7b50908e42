// What statics leaves undecided, let go in time: a wall that is pushed less than its friction bears comes to rest, and
// one that is pushed more moves on.
#include "run/settling_in_time.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "run/rigid_limits.hpp"
#include "run/static_theorem.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;

// Four courses are so low that they slide as a whole on their bed, at 0.6 g.
constexpr double critical = 0.6, unit = 0.15;

/// The wall under its weight, and the loads of a push of so many g.
struct Pushed {
  test::Experiment wall{test::wall_scene(4)};
  std::vector<double> before, load, prescribed;

  explicit Pushed(double push) {
    wall.advance({{"weight", 1.0}});
    before = wall.load();
    wall.model().loads({{"weight", 1.0}, {"sideways", push / unit}}, 0, load, prescribed);
  }
  Settled settled(int most_solves) {
    return settle_in_time(const_cast<PlaneModel&>(wall.model()), wall.step(), wall.state(), {before, load, prescribed},
                          most_solves);
  }
};

TEUCHOS_UNIT_TEST(SettlingInTime, ComesToRestBelowTheLimitAndIsAnEquilibriumThere) {
  Pushed pushed(0.9 * critical);
  const auto settled = pushed.settled(5000);
  TEST_ASSERT(settled.verdict == Verdict::equilibrium);
  TEST_ASSERT(settled.report.newton.outcome == NewtonOutcome::converged);
  TEST_ASSERT(settled.state.velocity.empty());
  double sideways = 0;  // what the ground holds is what pushes
  const auto left = pushed.wall.step().residual(settled.state, pushed.load);
  double pushes = 0;
  const auto& s = pushed.wall.model().structure();
  for (int n = 0; n < s.owned_nodes(); ++n) sideways += left[2 * n], pushes += pushed.load[2 * n];
  const auto& comm = *s.comm();
  TEST_FLOATING_EQUALITY(-total_over_ranks(comm, sideways), total_over_ranks(comm, pushes), 1e-6);
}

TEUCHOS_UNIT_TEST(SettlingInTime, MovesOnAboveTheLimit) {
  Pushed pushed(1.05 * critical);
  const auto settled = pushed.settled(5000);
  TEST_ASSERT(settled.verdict == Verdict::collapse);
  const auto& m = settled.mechanism;
  const auto& comm = *pushed.wall.model().structure().comm();
  TEST_FLOATING_EQUALITY(largest_over_ranks(comm, *std::max_element(m.begin(), m.end())), 1.0, 1e-3);
}

TEUCHOS_UNIT_TEST(SettlingInTime, GivesUpWhenItMaySolveNoMore) {
  Pushed pushed(1.05 * critical);
  const auto settled = pushed.settled(3);
  TEST_ASSERT(settled.verdict == Verdict::undecided);
  TEST_COMPARE(settled.solves, <=, 3);
}

TEUCHOS_UNIT_TEST(StaticTheorem, TellsWhatShareOfAStepCanBeBorne) {
  Pushed pushed(2 * critical);
  const RigidLimits limits(pushed.wall.model(), {nullptr, nullptr, pushed.load, {}});
  TEST_ASSERT(limits.bears(0).verdict == LimitVerdict::refused);
  auto more = pushed.load;
  for (std::size_t k = 0; k < more.size(); ++k) more[k] -= pushed.before[k];
  const RigidLimits raised(pushed.wall.model(), {nullptr, nullptr, pushed.before, more});
  const auto limit = raised.largest_factor(1);
  TEST_ASSERT(limit.verdict == LimitVerdict::limited);
  TEST_FLOATING_EQUALITY(limit.factor, 0.5, 1e-6);
}

}  // namespace
