// Limits of rigid structures in space of a hundred stones, proven from above and with forces found from below.
//
// Source     linear programmes of pyramids with 16 sides within the cones, by another solver.
// Tolerance  round cones bear no less than pyramids within and no more than 1 / cos(pi / 16) of it, walls at most a
//            hundredth more; what is proven and what is found meet within the thousandth to which pyramids are made
//            finer.
#include <Teuchos_UnitTestHarness.hpp>

#include "unit/statics/structures_in_space.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double degree = 3.14159265358979323846 / 180;

constexpr double of_walls = 1.01, of_cones = 1.0195911582083184;  // [-] most of what pyramids within bear

void check(RigidStructure<3> s, const Vector<3>& direction, double within, double most, Teuchos::FancyOStream& out,
           bool& success) {
  push_to(s, direction);
  const LimitAnalysis analysis(std::move(s));
  const auto limit = analysis.largest_factor(10), borne = analysis.largest_borne(10);
  out << "within " << within << ": proven above " << limit.factor << ", forces up to " << borne.factor << "\n";
  TEST_ASSERT(limit.verdict == LimitVerdict::limited);
  TEST_COMPARE(limit.factor, >=, within - 5e-5);  // as it is published
  TEST_COMPARE(limit.factor, <=, most * within);
  TEST_COMPARE(borne.factor, <=, limit.factor * (1 + 1e-9));
  TEST_COMPARE(borne.factor, >=, limit.factor * (1 - 2e-3));
  // Forces of one worth are not made to go round: to prove a limit takes no many times what it takes to find forces.
  TEST_COMPARE(limit.iterations, <=, 5 * borne.iterations);
  TEST_COMPARE(std::max(limit.out_of_balance, borne.out_of_balance), <=, 1e-8);
}

TEUCHOS_UNIT_TEST(RigidLimitsInSpace, AWallWithAReturn) {
  check(dry_wall(6, 10, 1, 0.6), {0, -1, 0}, 0.2193, of_walls, out, success);
  check(dry_wall(6, 10, 1, 0.6), {1, 0, 0}, 0.4369, of_walls, out, success);
}

TEUCHOS_UNIT_TEST(RigidLimitsOfMoreWallsInSpace, WithAReturnAndOtherFriction) {
  check(dry_wall(6, 10, 1, 0.4), {0, -1, 0}, 0.1911, of_walls, out, success);
  check(dry_wall(6, 10, 1, 0.75), {0, -1, 0}, 0.2298, of_walls, out, success);
}

TEUCHOS_UNIT_TEST(RigidLimitsOfMoreWallsInSpace, WithTwoReturns) {
  check(dry_wall(6, 10, 2, 0.6), {0, -1, 0}, 0.2878, of_walls, out, success);
}

TEUCHOS_UNIT_TEST(RigidLimitsInSpace, ADomePushedSideways) {
  check(dome(16, 8, 0.08, 5 * degree, 0.6), {1, 0, 0}, 0.3647, of_cones, out, success);
}

// By definition: a joint that leaves a share free bears forces of its corners, drawn to their mean by as much. Spread
// again over the whole joint they obey its law. Forces balance to 1e-8 of the largest load, here less than 1.
TEUCHOS_UNIT_TEST(RigidLimitsInSpace, AWallWithAReturnThatIsPushedLeavesAShareOfEveryJointFree) {
  auto s = dry_wall(6, 10, 1, 0.6);
  push_to(s, {0, -1, 0});
  const LimitAnalysis analysis(s);
  const auto borne = analysis.bears(0.15);
  double free_share = -1;
  const auto answer = analysis.most_balanced(0.15, &free_share, borne);
  TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
  TEST_COMPARE(free_share, >, 0);
  TEST_COMPARE(free_share, <, 1);
  const auto corners = joint_corners(s);
  const auto at = [&](int q) { return static_cast<std::size_t>(corners.kept[static_cast<std::size_t>(q)]); };
  for (std::size_t k = 0; k < corners.kept.size(); ++k) {
    Vector<3> mean{};
    for (int q = corners.first[k]; q < corners.first[k] + corners.count[k]; ++q)
      mean = mean + (1.0 / corners.count[k]) * answer.force[at(q)];
    const auto spread = mean + (1 / (1 - free_share)) * (answer.force[at(static_cast<int>(k))] - mean);
    TEST_COMPARE(length(tangential(spread)), <=, 0.6 * spread[0] + 1e-8);
  }
}

}  // namespace
