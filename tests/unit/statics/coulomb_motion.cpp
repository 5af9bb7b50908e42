// Mechanisms of limit analysis as Coulomb's friction has them: what slides stays closed, what tips still rises.
#include "statics/coulomb_motion.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "structures.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Rows of the programme are held to 1e-7 of the mechanism's largest motion, and the motion is a tenth of that and more.
constexpr double close = 2e-5;

const Wrench<2>& of(const LimitAnswer<2>& answer, int stone) {
  return answer.motion.at(static_cast<std::size_t>(stone));
}

/// Whether a motion closes no joint; how far joints open at most where the mechanism slides.
void check(const RigidStructure<2>& s, const LimitAnswer<2>& answer, Teuchos::FancyOStream& out, bool& success) {
  double closes = 0, lifts = 0, size = 0;
  for (const auto& m : answer.motion) size = std::max(size, std::hypot(m[0], m[1]));
  for (const auto& c : s.contacts) {
    const auto v = relative_velocity(c, answer.mechanism), w = relative_velocity(c, answer.motion);
    closes = std::max(closes, -w[0] / size);
    if (std::abs(v[1]) > 1e-5 && std::abs(v[0] - c.law.friction * std::abs(v[1])) < 1e-7)
      lifts = std::max(lifts, w[0] / size);
  }
  TEST_COMPARE(closes, <, close);
  // By the estimate without dilatancy what slides opens by a thousandth of what it would with it.
  TEST_ASSERT(answer.dilates ? answer.motion == answer.mechanism : lifts < 1e-3);
}

TEUCHOS_UNIT_TEST(CoulombMotion, AFlatStoneThatIsPushedSlidesAlongItsBed) {
  for (const double weight : {1.0, 1e6, 1e-6}) {
    const LimitAnalysis box(box_on_bed(2, 1, {0.6}, weight));
    for (const auto& answer : {box.largest_factor(10), box.bears(0.7)}) {
      TEST_COMPARE(answer.mechanism[1][1], >, 0.1);  // by the flow rule it rises
      TEST_ASSERT(!answer.dilates);
      TEST_COMPARE(of(answer, 1)[0], >, 0.1);
      TEST_COMPARE(std::abs(of(answer, 1)[1]), <, close);
      TEST_COMPARE(std::abs(of(answer, 1)[2]), <, close);
      for (const double v : of(answer, 0)) TEST_EQUALITY(v, 0.0);
    }
  }
}

TEUCHOS_UNIT_TEST(CoulombMotion, AStoneThatTipsRises) {
  const auto answer = LimitAnalysis(box_on_bed(0.4, 1, {0.6})).largest_factor(10);
  TEST_ASSERT(!answer.dilates);
  TEST_ASSERT(answer.motion == answer.mechanism);
  TEST_COMPARE(of(answer, 1)[1], >, 0.1);
}

TEUCHOS_UNIT_TEST(CoulombMotion, WhatStandsOnAStoneThatSlidesGoesWithIt) {
  auto s = box_on_bed(2, 1, {0.3});
  const int upper = add_box(s, {0.5, 1}, 1, 1, 1);
  add_joint(s, 1, upper, {0.5, 1}, {1.5, 1}, {0.7});
  push_sideways(s);
  const auto answer = LimitAnalysis(s).largest_factor(10);
  check(s, answer, out, success);
  TEST_ASSERT(!answer.dilates);
  TEST_COMPARE(std::abs(of(answer, upper)[0] - of(answer, 1)[0]), <, close);
  TEST_COMPARE(std::abs(of(answer, upper)[1]), <, close);
}

TEUCHOS_UNIT_TEST(CoulombMotion, AStoneGoesDownItsSlope) {
  // However little steeper it is than friction: the mechanism, which rises by the flow rule, then does next to no work.
  for (const double friction : {0.6, 0.1})
    for (const double steeper : {0.1, 1e-3, 1e-5, 1e-6})
      for (const double slope : {friction * (1 + steeper), -friction * (1 + steeper)}) {
        RigidStructure<2> s;
        const int bed = add_box(s, {-1, -2}, 2, 1, 0), stone = add_stone(s, {0, 0.5}, 1, 1);
        hold(s, bed);
        add_joint(s, bed, stone, {-1, -slope}, {1, slope}, {friction});
        const auto answer = LimitAnalysis(s).bears(0);
        TEST_ASSERT(answer.verdict == LimitVerdict::refused && !answer.dilates);
        const auto& motion = of(answer, stone);
        TEST_COMPARE(std::hypot(motion[0], motion[1]), >, 0.1);
        TEST_COMPARE(motion[1], <, 0);
        TEST_COMPARE(std::abs(motion[1] / motion[0] - slope), <, close);
      }
}

TEUCHOS_UNIT_TEST(CoulombMotion, AWedgeGoesDownAndWhatItPartsGoesAside) {
  // Two boxes on a bed and a wedge between them, whose flanks lean by one to four; it is loaded.
  RigidStructure<2> s;
  const int bed = add_box(s, {-3, -1}, 6, 1, 0), left = add_box(s, {-3, 0}, 2, 1, 1),
            right = add_box(s, {1, 0}, 2, 1, 1);
  const int wedge = add_stone(s, {0, 0.5}, 1, 0.1);
  hold(s, bed);
  add_joint(s, bed, left, {-3, 0}, {-1, 0}, {0.4});
  add_joint(s, bed, right, {1, 0}, {3, 0}, {0.4});
  add_joint(s, left, wedge, {-1.25, 1}, {-1, 0}, {0.1});
  add_joint(s, wedge, right, {1.25, 1}, {1, 0}, {0.1});
  s.stones[static_cast<std::size_t>(wedge)].raised = {0, -1, 0};
  const auto answer = LimitAnalysis(s).largest_factor(1e3);
  TEST_ASSERT(answer.verdict == LimitVerdict::limited);
  check(s, answer, out, success);
  TEST_COMPARE(of(answer, wedge)[1], <, -0.1);
  TEST_ASSERT(of(answer, left)[0] < -0.01 || of(answer, right)[0] > 0.01);
  TEST_COMPARE(std::max(std::abs(of(answer, left)[1]), std::abs(of(answer, right)[1])), <, close);
}

TEUCHOS_UNIT_TEST(CoulombMotion, WallsThatSlideEitherStayClosedThereOrSaySo) {
  const std::vector<int> half{1, 2, 2, 2, 2, 1}, whole{2, 2, 2, 2, 2};
  const std::vector<int> e{1, 2, 2, 1}, u{2, 2, 2}, x{2, -2, 2}, y{1, 1, -2, 1, 1};
  for (const auto& courses : {std::vector<std::vector<int>>{half, whole, half, whole, half, whole},
                              {e, u, e, x, y, x, y, x, e, u, e, x, y, x, y, x, e, u, e}})
    for (const double friction : {0.65, 0.3}) {
      const auto s = wall(courses, friction);
      const auto answer = LimitAnalysis(s).largest_factor(10);
      TEST_ASSERT(answer.verdict == LimitVerdict::limited);
      check(s, answer, out, success);
    }
}

TEUCHOS_UNIT_TEST(CoulombMotion, AStoneThatMustClimbOutOfATeethedBedSaysThatItDilates) {
  // By hand: a stone jammed between a bed and a ceiling could only move by opening both as it slides.
  RigidStructure<2> s;
  const int bed = add_box(s, {0, -1}, 2, 1, 0), stone = add_box(s, {0, 0}, 2, 1, 1);
  hold(s, bed);
  add_joint(s, bed, stone, {0, 0}, {2, 0}, {0.5});
  add_joint(s, bed, stone, {2, 1}, {2, 0}, {0.5});  // a tooth at its right side: opens as the stone goes to the left
  add_joint(s, bed, stone, {0, 0}, {0, 1}, {0.5});  // and one at its left
  const std::vector<Wrench<2>> mechanism{{}, {0.0, 1.0, 0.0}}, loads{{}, {0.0, 1.0, 0.0}};
  TEST_ASSERT(!coulomb_motion(s, mechanism, loads).dilates);  // straight up it neither rubs nor slides
  const std::vector<Wrench<2>> aslant{{}, {1.0, 0.5, 0.0}}, push{{}, {0.0, 1.0, 0.0}};
  const auto lifted = coulomb_motion(s, aslant, push);  // slides by the flow rule; pushed upwards it must lift
  TEST_ASSERT(lifted.dilates);
  TEST_ASSERT(lifted.of_stones == aslant);
}

}  // namespace
