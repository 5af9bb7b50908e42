// Supports, ranges of reactions and the most balanced forces of rigid structures against closed forms.
#include <Teuchos_UnitTestHarness.hpp>
#include <random>

#include "unit/statics/structures.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double close = 1e-8, most = 100;

RigidStructure<2> box_on_rollers(double second_roller) {
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 1, 1);
  for (const double x : {-0.5, second_roller}) s.supports.push_back({0, {x, -0.5}, {0, 1}, 0});
  push_sideways(s);
  return s;
}

TEUCHOS_UNIT_TEST(Supports, RollersBearWeightAndNothingSideways) {
  const LimitAnalysis rolls(box_on_rollers(0.5));
  TEST_ASSERT(rolls.bears(0).verdict == LimitVerdict::unlimited);
  TEST_ASSERT(rolls.bears(1e-3).verdict == LimitVerdict::refused);
  const auto answer = rolls.largest_factor(most);
  TEST_ASSERT(answer.verdict == LimitVerdict::limited);
  TEST_ASSERT(std::abs(answer.factor) < close);
  TEST_FLOATING_EQUALITY(answer.mechanism.at(0)[0], 1.0, close);
  auto stopped = box_on_rollers(0.5);
  stopped.supports.push_back({0, {0.5, 0.5}, {1, 0}, 1});
  TEST_ASSERT(LimitAnalysis(stopped).largest_factor(most).verdict == LimitVerdict::unlimited);
}

TEUCHOS_UNIT_TEST(Supports, OneNodeAloneLetsAStoneTurn) {
  auto s = box_on_rollers(-0.5);
  s.supports.push_back({0, {-0.5, -0.5}, {1, 0}, 0});
  const auto answer = LimitAnalysis(s).bears(0);
  TEST_ASSERT(answer.verdict == LimitVerdict::refused);
  TEST_ASSERT(answer.mechanism.at(0)[2] < -0.1);  // about the lower left corner
}

TEUCHOS_UNIT_TEST(Supports, AHeldSideBearsBothWaysAndAtAnAngle) {
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 1, 1);
  const Vector<2> slope{0.6, 0.8}, across{-0.8, 0.6};
  for (const double x : {-1.0, 1.0}) s.supports.push_back({0, x * across, slope, 0});
  // Held along the slope alone: of a weight 0.6 pull along the way that is left.
  TEST_ASSERT(LimitAnalysis(s).bears(0).verdict == LimitVerdict::refused);
  s.stones[0].raised = {0.75, 0, 0};
  TEST_ASSERT(LimitAnalysis(s).bears(1).verdict == LimitVerdict::refused);
  s.stones[0].raised = {-0.75, 0, 0};  // with the weight along the slope
  TEST_ASSERT(LimitAnalysis(s).bears(1).verdict == LimitVerdict::unlimited);
}

/// A box with the nodes of its foot held, as a measured drawing has them: off their line by so much.
RigidStructure<2> box_on_measured_foot(double off, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-off, off);
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 1, 1);
  for (int k = 0; k < 9; ++k)
    for (const auto& direction : {Vector<2>{1, 0}, Vector<2>{0, 1}})
      s.supports.push_back({0, {k / 8.0 - 0.5 + by(random), -0.5 + by(random)}, direction, 0});
  return s;
}

TEUCHOS_UNIT_TEST(Supports, AMeasuredFootIsHeldAsADrawnOne) {
  for (int digits = 1; digits < 12; ++digits)
    for (unsigned seed = 0; seed < 20; ++seed) {
      const LimitAnalysis held(box_on_measured_foot(std::pow(10.0, -digits), seed));
      TEST_ASSERT(held.bears(0).verdict == LimitVerdict::unlimited);
    }
}

/// Three stones of weight 1 and a x h side by side between two held abutments.
RigidStructure<2> flat_arch(double a, double h, double friction) {
  RigidStructure<2> s;
  for (int k = -1; k <= 3; ++k) {
    const int stone = add_box(s, {k * a, 0}, a, h, k < 0 || k == 3 ? 0 : 1);
    if (k >= 0) add_joint(s, stone - 1, stone, {k * a, h}, {k * a, 0}, {friction});
  }
  hold(s, 0, 0);
  hold(s, 4, 1);
  return s;
}

TEUCHOS_UNIT_TEST(Reactions, TheLeastThrustOfAFlatArch) {
  // The line of thrust rises by the height over one stone, or the ends slide down: h H >= w a, mu H >= 3 w / 2.
  const double a = 0.7, h = 0.4;
  for (const double friction : {0.5, 1.0, endless}) {
    const LimitAnalysis arch(flat_arch(a, h, friction));
    const auto ranges = arch.reactions(2, 0);
    const auto &left = ranges[0][0], &right = ranges[1][0], &up = ranges[0][1];
    const double thrust = std::max(a / h, 1.5 / friction);
    TEST_ASSERT(left.least.has_value() && !left.most.has_value());
    TEST_FLOATING_EQUALITY(left.least.value_or(0), thrust, close);
    TEST_ASSERT(right.most.has_value() && !right.least.has_value());
    TEST_FLOATING_EQUALITY(right.most.value_or(0), -thrust, close);
    TEST_ASSERT(!up.most.has_value() || *up.most >= 1.5);
  }
}

TEUCHOS_UNIT_TEST(Reactions, AStoneBetweenFrictionAndAWall) {
  // Pushed to the right by a factor of its weight against a smooth wall: friction takes as much as 0.6 either way.
  RigidStructure<2> s = box_on_bed(4, 1, {0.6});
  const int beside = add_box(s, {4, 0}, 1, 1, 0);
  hold(s, beside, 7);
  add_joint(s, 1, beside, {4, 1}, {4, 0}, {0});
  const LimitAnalysis analysis(s);
  for (const double factor : {0.0, 0.5, 1.5}) {
    const auto ranges = analysis.reactions(8, factor);
    const auto& range = ranges[7][0];
    TEST_ASSERT(range.least && range.most);
    TEST_ASSERT(std::abs(range.least.value_or(9) + (factor + 0.6)) < close);
    TEST_ASSERT(std::abs(range.most.value_or(9) + std::max(0.0, factor - 0.6)) < close);
    const auto& of_bed = ranges[0][1];
    TEST_FLOATING_EQUALITY(of_bed.least.value_or(0), 1.0, close);
    TEST_FLOATING_EQUALITY(of_bed.most.value_or(0), 1.0, close);
    const auto& shear = ranges[0][0];
    TEST_ASSERT(std::abs(shear.most.value_or(9) - 0.6) < close);
    TEST_ASSERT(std::abs(shear.least.value_or(9) - std::max(-0.6, -factor)) < close);
  }
  const auto none = LimitAnalysis(box_on_bed(1, 1, {0.6})).reactions(1, 0.7)[0][0];
  TEST_ASSERT(!none.least && !none.most);  // no forces balance these loads
}

TEUCHOS_UNIT_TEST(AnyFactor, IsBorneWhereJointsBalanceTheRaisedLoadsAlone) {
  // A box on a bed under a force whose angle to the normal of the bed is within its friction, or beyond it.
  for (const double sideways : {0.3, 0.9}) {
    RigidStructure<2> s = box_on_bed(4, 1, {0.6});
    s.stones[1].raised = {sideways, -1, 0};
    const LimitAnalysis analysis(s);
    TEST_EQUALITY(analysis.borne_at_any_factor(), sideways < 0.6);
    TEST_EQUALITY(analysis.largest_factor(1e4).verdict == LimitVerdict::unlimited, sideways < 0.6);
  }
  // Cohesion bears so much and no more.
  RigidStructure<2> glued = box_on_bed(4, 1, {0.6, 10, 0});
  glued.stones[1].raised = {0.9, -1, 0};
  TEST_ASSERT(!LimitAnalysis(glued).borne_at_any_factor());
  TEST_ASSERT(LimitAnalysis(glued).bears(1).verdict == LimitVerdict::unlimited);
}

TEUCHOS_UNIT_TEST(MostBalanced, AColumnUnderALoadOffItsMiddle) {
  const double width = 0.5, part = 1.0 / 1024;  // of the bisection
  for (const double eccentricity : {0.0, 0.05, 0.2}) {
    RigidStructure<2> s;
    for (int k = 0; k < 4; ++k) {
      add_box(s, {0, 0.3 * k}, width, 0.3, k == 0 ? 0 : 0.1);
      if (k > 0) add_joint(s, k - 1, k, {0, 0.3 * k}, {width, 0.3 * k}, {0.5});
    }
    hold(s, 0);
    s.stones[3].raised = {0, -10, -10 * eccentricity};
    double free_share = -1;
    const auto answer = LimitAnalysis(s).most_balanced(1, &free_share);
    TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
    TEST_ASSERT(answer.out_of_balance < close);
    // The load is farthest from the middle where the least weight has come to it: below the highest stone.
    const double off = 10 * eccentricity / 10.1;
    TEST_ASSERT(std::abs(free_share - (1 - 2 * off / width)) <= part + close);
    // Forces are told at the ends of joints, with the resultant where it passes.
    double moment = 0, normal = 0;
    for (std::size_t k = 4; k < 6; ++k) {
      const double middle = 0.5 * (s.contacts[4].arm_i[0] + s.contacts[5].arm_i[0]);
      moment += answer.force[k][0] * (s.contacts[k].arm_i[0] - middle);
      normal += answer.force[k][0];
    }
    TEST_FLOATING_EQUALITY(normal, 10.1, close);
    TEST_ASSERT(std::abs(std::abs(moment) - 10 * eccentricity) < 1e-6);
  }
}

TEUCHOS_UNIT_TEST(MostBalanced, TheLineOfThrustOfAFlatArchRisesOverAllItMay) {
  // With so much friction that thrust can grow without end the line is as flat as one likes.
  double free_share = -1;
  LimitAnalysis(flat_arch(0.7, 0.4, endless)).most_balanced(0, &free_share);
  TEST_ASSERT(free_share > 0.99);
  const auto refused = LimitAnalysis(flat_arch(0.7, 0.4, 0)).most_balanced(0, &free_share);
  TEST_ASSERT(refused.verdict != LimitVerdict::unlimited);
  TEST_EQUALITY(free_share, 0);
}

TEUCHOS_UNIT_TEST(MostBalanced, TheFreeShareOfAnArchIsThatOfTheThinnestInsideIt) {
  // A semicircle that is t thick holds the thinnest that stands, which is nearly 0.10678 thick, about the same middle.
  double free_share = -1;
  const double thickness = 0.15;
  LimitAnalysis(ring(27, 1, thickness, pi, {1.0})).most_balanced(0, &free_share);
  // Its stones are heavier outside, so that the loads differ by a little.
  TEST_FLOATING_EQUALITY(1 - free_share, 0.10678 / thickness, 0.01);
}

TEUCHOS_UNIT_TEST(Rows, AnArchAndAColumnAreRowsRingsOnEachOtherAndWallsAreNone) {
  TEST_ASSERT(LimitAnalysis(ring(7, 10, 1.5, pi, {0.6})).is_rows());
  TEST_ASSERT(LimitAnalysis(box_on_bed(1, 1, {0.6})).is_rows());
  auto two = box_on_bed(2, 1, {0.6});
  const int upper = add_box(two, {0, 1}, 2, 1, 1);
  add_joint(two, 1, upper, {0, 1}, {2, 1}, {0.6});
  TEST_ASSERT(LimitAnalysis(two).is_rows());
  hold(two, 1);  // held in the middle of the row
  TEST_ASSERT(!LimitAnalysis(two).is_rows());
  TEST_ASSERT(!LimitAnalysis(wall({{1, 2, 2, 1}, {2, 2, 2}, {1, 2, 2, 1}}, 0.6)).is_rows());
  auto glued = box_on_bed(1, 1, {0.6, 1, 0});  // joints with strength are not narrowed
  TEST_ASSERT(!LimitAnalysis(glued).is_rows());
}

}  // namespace
