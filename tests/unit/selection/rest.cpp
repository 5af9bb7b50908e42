// When a point that rests is bonded, and when it is again after a release.
#include "selection/rest.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace {

using namespace voussoir;

// One point of stiffness 2 N/m, so that a motion of 1 m is worth 1 J; rests below 1/4 J, which is half a metre.
struct Point {
  Rest rest;
  std::vector<char> selected = {1}, calm = {1};
  bool step(double gap, double slip) { return bond_what_rests(rest, selected, {gap, slip}, {2.0}, calm, 0.25, 3); }
};

TEUCHOS_UNIT_TEST(Rest, APointIsBondedAfterThreeStepsOfRest) {
  Point p;
  TEST_ASSERT(!p.step(7, 0) && !p.step(7, 0));
  TEST_ASSERT(p.selected[0]);
  TEST_ASSERT(p.step(7, 0));
  TEST_ASSERT(!p.selected[0]);
}

TEUCHOS_UNIT_TEST(Rest, WhatIsRememberedInPartOnlyBeginsAnew) {
  Point p;
  p.rest.place = {7, 0};  // as a checkpoint may have it that lacks the other tables
  TEST_ASSERT(!p.step(7, 0) && !p.step(7, 0) && p.step(7, 0));
}

TEUCHOS_UNIT_TEST(Rest, SlowMotionIsNoRest) {
  Point p;
  for (int k = 0; k < 20; ++k) TEST_ASSERT(!p.step(0, 0.3 * k));  // half a metre off its place with every second step
  TEST_ASSERT(p.selected[0]);
}

TEUCHOS_UNIT_TEST(Rest, VibrationAboutAPlaceIsRest) {
  Point p;
  p.step(0, 0);
  p.step(0.3, 0.3);
  TEST_ASSERT(p.step(-0.3, 0.3));
}

TEUCHOS_UNIT_TEST(Rest, APointThatATieWouldStopIsNotBonded) {
  Point p;
  p.calm = {0};
  for (int k = 0; k < 20; ++k) TEST_ASSERT(!p.step(0, 0));
  p.calm = {1};
  TEST_ASSERT(!p.step(0, 0) && !p.step(0, 0) && p.step(0, 0));
}

TEUCHOS_UNIT_TEST(Rest, APointReleasedSoonMustRestTwiceAsLongUntilItIsTrustedAgain) {
  Point p;
  std::vector<int> needed;
  for (const int bonded_before : {0, 0, 0, 200}) {  // the last: more than 16 times the 12 steps it had to rest
    for (int k = 0; k < bonded_before; ++k) p.step(0, 0);
    p.selected[0] = 1;  // released
    needed.push_back(0);
    while (p.selected[0] && needed.back() < 100) {
      p.step(0, 0);
      ++needed.back();
    }
  }
  const std::vector<int> expected = {3, 6, 12, 6};
  TEST_COMPARE_ARRAYS(needed, expected);
}

TEUCHOS_UNIT_TEST(Rest, APointThatHasRestedIsBondedAtOnceWhereItIs) {
  Point p;
  p.rest = rested({7, 0}, 1, 3);
  TEST_ASSERT(p.step(7, 0));
  Point moved;
  moved.rest = rested({7, 0}, 1, 3);
  TEST_ASSERT(!moved.step(8, 0) && moved.selected[0]);
}

TEUCHOS_UNIT_TEST(KnownError, IsSoManyTimesTheRootUntilItIsComputed) {
  KnownError error;
  error.follow(0.1);
  TEST_EQUALITY(error.bound(5), 5 * 0.1);
}

TEUCHOS_UNIT_TEST(KnownError, IsItselfWhereNothingMovesAndLessSureTheMoreTheRootHasMoved) {
  KnownError error;
  error.follow(0.1);
  error.learn(0.3);
  TEST_FLOATING_EQUALITY(error.bound(5), 0.3, 1e-15);
  error.follow(0.101);
  TEST_FLOATING_EQUALITY(error.bound(5), 3 * (0.101 + 2 * 0.001), 1e-12);
  error.follow(0.1);  // there and back
  TEST_FLOATING_EQUALITY(error.bound(5), 3 * (0.1 + 2 * 0.002), 1e-12);
  error.follow(0.18);
  TEST_FLOATING_EQUALITY(error.bound(5), 1.5 * 3 * 0.18, 1e-12);  // no further than the margin
}

// Else an error computed where next to nothing was wrong would be believed for ever.
TEUCHOS_UNIT_TEST(KnownError, SaysNothingOfARootTwiceAsLarge) {
  KnownError error;
  error.follow(0.1);
  error.learn(1e-6);
  error.follow(0.21);
  TEST_EQUALITY(error.bound(5), 5 * 0.21);
}

}  // namespace
