// Limits of rigid structures in space against closed forms and a programme of their own.
//
// Source     the wall with a return and the dome: linear programmes of pyramids with 16 sides within the cones, by
//            another solver. Round cones bear no less.
// Tolerance  what pyramids are made finer to, a thousandth of friction; closed forms of tipping 1e-8.
#include <Teuchos_UnitTestHarness.hpp>
#include <random>

#include "unit/statics/structures_in_space.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double finer = 1.5e-3, close = 1e-8, most = 10;
constexpr double degree = 3.14159265358979323846 / 180;

double largest_friction(const PointLaw& law, double normal) { return law.cohesion + law.friction * normal; }

const PointLaw laws[] = {{0.6, 0, 0}, {0.6, 3, 0}, {0.6, 3, 2}, {0.5, 1, 7}, {0, 0, 0}, {0, 2, 1}};

TEUCHOS_UNIT_TEST(PyramidsInSpace, LieAroundTheLawAndWithinIt) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(0, 360 * degree), share(0, 1);
  for (const auto& law : laws) {
    const auto around = admissible_forces<3>(law), within = admissible_forces<3>(law, Pyramid::within);
    for (int k = 0; k < 500; ++k) {
      // Of a compatible motion the pyramid around absorbs no less than the law, that within no more.
      const double a = angle(random), slip = share(random);
      const double edge = 1 / std::cos(RoundConeParameters::side / 2);
      const Vector<3> motion{edge * law.friction * slip + share(random), slip * std::cos(a), slip * std::sin(a)};
      const auto exact = absorbed_at_most(law, motion);
      TEST_EQUALITY(exact.against, 0);
      TEST_COMPARE(absorbed_at_most(around, motion).power, >=, exact.power - 1e-12);
      TEST_COMPARE(absorbed_at_most(within, motion).power, <=, exact.power + 1e-12);
      auto force = within.apex;
      for (const auto& g : within.generators)
        force = force + (g.lower + share(random) * (std::min(g.upper, 10.0) - g.lower)) * g.direction;
      TEST_COMPARE(length(tangential(force)), <=, largest_friction(law, force[0]) + 1e-12);
      TEST_COMPARE(force[0], >=, -law.tension - 1e-12);
    }
  }
}

TEUCHOS_UNIT_TEST(PyramidsInSpace, WhatTheLawAbsorbsIsItsSupport) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 360 * degree), share(0, 1);
  for (const auto& law : laws)
    for (int k = 0; k < 200; ++k) {
      const double a = angle(random), slip = share(random), opens = share(random) - 0.2;
      const auto absorbed = absorbed_at_most(law, Vector<3>{opens, slip * std::cos(a), slip * std::sin(a)});
      const double presses = law.friction * slip - opens;
      if (presses > 0) {
        TEST_FLOATING_EQUALITY(absorbed.against, presses / std::hypot(1, law.friction), 1e-12);
        continue;
      }
      double power = -endless;  // forces against the slip, at the least normal force and far beyond it
      for (const double n :
           {law.friction > 0 ? std::max(-law.tension, -law.cohesion / law.friction) : -law.tension, 9.0})
        power = std::max(power, largest_friction(law, n) * slip - n * opens);
      TEST_EQUALITY(absorbed.against, 0);
      TEST_FLOATING_EQUALITY(1 + absorbed.power, 1 + power, 1e-12);
    }
  TEST_EQUALITY(absorbed_at_most(PointLaw{endless, 3, 2}, Vector<3>{0, 0.6, 0.8}).against, 1);
  TEST_EQUALITY(absorbed_at_most(PointLaw{0.6, endless, 0}, Vector<3>{1, 0, 0}).against, 0);
  TEST_EQUALITY(absorbed_at_most(PointLaw{0.6, endless, endless}, Vector<3>{1, 0, 0}).against, 1);
  TEST_EQUALITY(absorbed_at_most(PointLaw{0, 2, endless}, Vector<3>{0, 0.6, 0.8}).power, 2);
}

/// Turned off all axes: places, loads and axes of joints.
RigidStructure<3> turned(RigidStructure<3> s) {
  const auto turn = [](const Vector<3>& v) {
    const double c = std::cos(0.5), d = std::sin(0.5), e = std::cos(0.7), f = std::sin(0.7);
    const Vector<3> w{c * v[0] - d * v[1], d * v[0] + c * v[1], v[2]};
    return Vector<3>{w[0], e * w[1] - f * w[2], f * w[1] + e * w[2]};
  };
  for (auto& stone : s.stones)
    for (auto* w : {&stone.fixed, &stone.raised}) {
      const auto force = turn(force_of(*w)), moment = turn(moment_of(*w));
      *w = {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
    }
  for (auto& c : s.contacts) {
    c.arm_i = turn(c.arm_i), c.arm_j = turn(c.arm_j);
    for (auto& axis : c.axis) axis = turn(axis);
    const auto across = c.axis[1];  // tangents that are no axis of anything
    c.axis[1] = std::cos(0.3) * across + std::sin(0.3) * c.axis[2];
    c.axis[2] = cross(c.axis[0], c.axis[1]);
  }
  for (auto& support : s.supports) support.arm = turn(support.arm);
  return s;
}

// Nodes of a measured drawing lie off their plane, by little or less: six ways are held, and nothing a seventh time.
TEUCHOS_UNIT_TEST(InSpace, AMeasuredFootIsHeldAsADrawnOne) {
  for (int digits = 1; digits < 12; ++digits)
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::mt19937 random(seed);
      const double off = std::pow(10.0, -digits);
      std::uniform_real_distribution<double> by(-off, off);
      auto s = prism(0, {0.6, 0, 0});
      s.supports.clear();
      for (int node = 0; node < 12; ++node) {
        const Vector<3> arm{node % 4 / 3.0 - 0.5 + by(random), node / 4 * 0.3 - 0.3 + by(random), -0.5 + by(random)};
        for (std::size_t c = 0; c < 3; ++c) {
          Vector<3> direction{};
          direction[c] = 1;
          s.supports.push_back({0, arm, direction, 0});
        }
      }
      TEST_ASSERT(LimitAnalysis(s).bears(0).verdict == LimitVerdict::unlimited);
    }
}

TEUCHOS_UNIT_TEST(InSpace, APrismTipsOverAnEdgeOrACornerOrSlides) {
  for (const double degrees : {0.0, 17.0, 30.0, 45.0, 60.0, 90.0})
    for (const double friction : {0.6, 0.2}) {
      const double tips = std::min(0.5 / std::cos(degrees * degree), 0.3 / std::max(1e-9, std::sin(degrees * degree)));
      const auto s = prism(degrees, {friction});
      for (const auto& drawn : {s, turned(s)}) {
        const LimitAnalysis analysis(drawn);
        const auto answer = analysis.largest_factor(most);
        TEST_ASSERT(answer.verdict == LimitVerdict::limited);
        const double expected = std::min(friction, tips), tolerance = tips < friction ? close : finer;
        TEST_COMPARE(answer.factor, >=, expected * (1 - close));
        TEST_COMPARE(answer.factor, <=, expected * (1 + tolerance));
        const auto borne = analysis.largest_borne(most);
        TEST_COMPARE(borne.factor, <=, expected * (1 + close));
        TEST_COMPARE(borne.factor, >=, expected * (1 - tolerance));
        TEST_ASSERT(analysis.bears(1.002 * expected).verdict == LimitVerdict::refused);
        TEST_ASSERT(analysis.bears(0.998 * expected).verdict == LimitVerdict::unlimited);
      }
    }
}

TEUCHOS_UNIT_TEST(InSpace, AStoneThatIsPushedSlidesOnItsBedTheWayItIsPushed) {
  for (const double degrees : {10.0, 45.0, 100.0}) {
    const auto answer = LimitAnalysis(prism(degrees, {0.2})).largest_factor(most);
    TEST_ASSERT(!answer.dilates);
    const auto& motion = answer.motion.at(1);
    TEST_COMPARE(answer.mechanism.at(1)[2], >, 0.1);  // by the flow rule it rises
    TEST_COMPARE(std::abs(motion[2]), <, 2e-5);
    TEST_COMPARE(std::cos(degrees * degree) * motion[0] + std::sin(degrees * degree) * motion[1], >, 0.1);
  }
}

TEUCHOS_UNIT_TEST(InSpace, CornersStandForAllPointsOfADryFlatJoint) {
  const double few = LimitAnalysis(prism(30, {0.6})).largest_factor(most).factor;
  const auto s = prism(30, {0.6}, 5);
  const auto answer = LimitAnalysis(s).largest_factor(most);
  TEST_FLOATING_EQUALITY(answer.factor, few, close);
  TEST_EQUALITY(joint_corners(s).kept.size(), 4);
  auto bent = s;  // in a joint that is not flat every point bears
  bent.contacts[7].axis = {bent.contacts[7].axis[1], bent.contacts[7].axis[2], bent.contacts[7].axis[0]};
  TEST_EQUALITY(joint_corners(bent).kept.size(), 25);
  TEST_EQUALITY(joint_corners(prism(0, {0.6, 1, 0}, 3)).kept.size(), 9);
}

TEUCHOS_UNIT_TEST(InSpace, CohesionAndTensionAddToWhatAJointBears) {
  // Weight 1.2 on four points. Sliding: friction and the cohesion of all. Tipping over an edge: tension of two.
  const double cohesion = 0.05, tension = 0.02, weight = 1.2;
  const auto slides = LimitAnalysis(prism(30, {0.1, cohesion, tension})).largest_factor(most);
  TEST_COMPARE(slides.factor, >=, 0.1 + 4 * cohesion / weight - close);
  TEST_COMPARE(slides.factor, <=, (0.1 + 4 * cohesion / weight) * 1.02);
  const auto tips = LimitAnalysis(prism(0, {0.9, 1, tension})).largest_factor(most);
  TEST_FLOATING_EQUALITY(tips.factor, 0.5 + 2 * tension / weight, close);
}

TEUCHOS_UNIT_TEST(InSpace, TheResultantOfAPushedPrismLeavesItsEdge) {
  auto s = prism(0, {0.6});
  const LimitAnalysis analysis(s);
  double free_share = -1;
  const auto answer = analysis.most_balanced(0.2, &free_share);
  TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
  TEST_FLOATING_EQUALITY(1 - free_share, 0.4, 0.03);  // off the middle by 0.2 m of 0.5 m, to a 64th
  TEST_ASSERT(analysis.is_rows());
  const auto ranges = analysis.reactions(1, 0.2)[0];
  const double weight = 1.2 + 0.6, push = 0.2 * weight;  // the bed is pushed too
  for (const auto& [range, force] : {std::make_pair(ranges[0], -push), {ranges[1], 0.0}, {ranges[2], weight}}) {
    TEST_COMPARE(std::abs(range.least.value_or(9) - force), <, 1e-7);
    TEST_COMPARE(std::abs(range.most.value_or(9) - force), <, 1e-7);
  }
}

// What slides at friction 0.2 stands at 0.2 / q, whichever way it is pushed and drawn; its resultant leaves the middle
// of the bed by as much as its middle is high, 1 m.
TEUCHOS_UNIT_TEST(InSpace, TheShareThatForcesLeaveFreeIsThatOfTheRoundConeInAnyDirection) {
  for (const double degrees : {0.0, 5.0, 11.25, 37.0, 101.0})
    for (const double q : {1.00001, 1.0001, 1.01, 1.018, 1.03}) {
      const auto s = prism(degrees, {0.2});
      for (const auto& drawn : {s, turned(s)}) {
        const LimitAnalysis analysis(drawn);
        TEST_ASSERT(analysis.bears(0.2 / q).verdict == LimitVerdict::unlimited);
        TEST_ASSERT(analysis.bears(0.2 * q).verdict == LimitVerdict::refused);
        double free_share = -1;
        const auto answer = analysis.most_balanced(0.2 / q, &free_share);
        TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
        TEST_COMPARE(answer.out_of_balance, <, close);
        const double x = std::abs(std::cos(degrees * degree)) / 0.5, y = std::sin(degrees * degree) / 0.3;
        const double needed = 0.2 / q * std::max(x, y);
        TEST_COMPARE(1 - free_share, >=, needed - close);
        TEST_COMPARE(1 - free_share, <=, needed + RoundConeParameters::share_told);
      }
    }
}

// Two stones on each other, whose joints differ in friction: the upper one leans on nearly all of its own.
TEUCHOS_UNIT_TEST(InSpace, TheFreeShareOfATowerOfWhichOneJointAloneNearlySlides) {
  auto s = prism(23, {0.6});
  const int top = add_box(s, {0, 0, 2}, {1, 0.6, 3});
  add_joint(s, 1, top, {{0, 0, 2}, {1, 0, 2}, {1, 0.6, 2}, {0, 0.6, 2}}, {0, 0, 1}, {0.1});
  push_to(s, {std::cos(23 * degree), std::sin(23 * degree), 0});
  for (const auto& drawn : {s, turned(s)}) {
    double free_share = -1;
    const auto answer = LimitAnalysis(drawn).most_balanced(0.1 / 1.005, &free_share);
    TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
    // At the foot, 1.5 m below the middle of both.
    const double needed = 0.15 / 1.005 * std::max(std::cos(23 * degree) / 0.5, std::sin(23 * degree) / 0.3);
    TEST_COMPARE(1 - free_share, >=, needed - close);
    TEST_COMPARE(1 - free_share, <=, needed + RoundConeParameters::share_told);
  }
}

double limit_of(RigidStructure<3> s, const Vector<3>& direction) {
  push_to(s, direction);
  const auto answer = LimitAnalysis(std::move(s)).largest_factor(most);
  return answer.verdict == LimitVerdict::limited ? answer.factor : -1;
}

TEUCHOS_UNIT_TEST(InSpace, DryWallsFallOutOfTheirPlane) {
  TEST_FLOATING_EQUALITY(limit_of(dry_wall(6, 10, 0, 0.6), {0, -1, 0}), 0.1, close);
  const double limit = limit_of(dry_wall(6, 10, 1, 0.6), {0, -1, 0});
  TEST_COMPARE(limit, >=, 0.2193 - 1e-4);
  TEST_COMPARE(limit, <=, 1.01 * 0.2193);
}

TEUCHOS_UNIT_TEST(InSpace, AWallThatFallsTurnsAboutItsFoot) {
  auto s = dry_wall(3, 4, 0, 0.6);
  push_to(s, {0, -1, 0});
  const LimitAnalysis analysis(s);
  const auto answer = analysis.largest_factor(most);
  TEST_FLOATING_EQUALITY(answer.factor, 0.25, close);
  TEST_ASSERT(!answer.dilates);
  TEST_COMPARE(answer.out_of_balance, <, close);
  const auto borne = analysis.largest_borne(most);
  TEST_FLOATING_EQUALITY(borne.factor, 0.25, 1e-6);
}

TEUCHOS_UNIT_TEST(InSpace, ADomeStandsWhereItsHoopsPart) {
  TEST_ASSERT(LimitAnalysis(dome(16, 8, 0.0410, 5 * degree, 0.6)).refuses(0).verdict == LimitVerdict::refused);
  TEST_ASSERT(LimitAnalysis(dome(16, 8, 0.0415, 5 * degree, 0.6)).largest_borne(1).verdict == LimitVerdict::unlimited);
}

}  // namespace
