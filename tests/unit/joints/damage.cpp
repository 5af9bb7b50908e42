// Damage is held, wears and is given back as computed by hand: half of a strength is half of the way to its end.
#include "joints/damage.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <vector>

namespace {

using namespace voussoir;

const PointLaw mortar{0.6, 1e5, 5e4};  // [-, N, N]
constexpr double end = 4e-4;           // [m] opening that takes all its 10 J; of slip, whose 50 J, 1e-3
constexpr double stones = 1e10;        // [N/m]

SofteningPoint point(bool brittle = false) { return {mortar, {5e4 / 10, 1e5 / 50, false, brittle, brittle}, {}, 0}; }

PointLoading opening(double gap, double normal) { return {gap, 0, normal, 0, stones}; }

TEUCHOS_UNIT_TEST(Damage, StrengthThatIsHeldStaysWhereverThePointGoes) {
  for (const PointDamage half : {PointDamage{end / 2, end / 2, 0}, PointDamage{0, end / 2, 0}})
    for (const double gap : {end / 2, end, 1.0})
      for (const double slip : {0.0, 1.0}) {
        const auto held = law_at(point(), half, StrengthIs::held, gap, slip);
        TEST_EQUALITY(held.pull, 25e3);
        TEST_EQUALITY(held.law.tension, 25e3);
        TEST_EQUALITY(held.law.cohesion, 50e3);
        TEST_EQUALITY(held.pull_per_opening, 0);
        TEST_EQUALITY(held.pull_per_slip, 0);
        TEST_EQUALITY(held.cohesion_per_gap, 0);
        TEST_EQUALITY(held.cohesion_per_slip, 0);
      }
  const auto sound = law_at(point(), {}, StrengthIs::held, 1.0, 1.0);
  TEST_EQUALITY(sound.pull, 50e3);
  TEST_EQUALITY(sound.law.cohesion, 100e3);
}

TEUCHOS_UNIT_TEST(Damage, StrengthFallsFromTheDamageThatThereIs) {
  const PointDamage half{end / 2, end / 2, 0};
  const auto on = law_at(point(), half, StrengthIs::falling, 0.75 * end, 0);
  TEST_FLOATING_EQUALITY(on.pull, 12.5e3, 1e-14);
  TEST_FLOATING_EQUALITY(on.pull_per_opening, -50e3 / end, 1e-14);
  TEST_EQUALITY(law_at(point(), half, StrengthIs::falling, end, 0).pull, 0);
  // Slipped by half of the way to the end before: what slips less loses no more.
  const PointDamage slipped{0, 0, 0.5e-3};
  TEST_FLOATING_EQUALITY(law_at(point(), slipped, StrengthIs::falling, 0, 0.25e-3).law.cohesion, 50e3, 1e-14);
  TEST_EQUALITY(law_at(point(), slipped, StrengthIs::falling, 0, 0.25e-3).cohesion_per_slip, 0);
  TEST_FLOATING_EQUALITY(law_at(point(), slipped, StrengthIs::falling, 0, 0.75e-3).law.cohesion, 25e3, 1e-14);
  TEST_FLOATING_EQUALITY(law_at(point(), slipped, StrengthIs::falling, 0, 0.75e-3).cohesion_per_slip, -1e8, 1e-14);
}

TEUCHOS_UNIT_TEST(Damage, APointThatHasOpenedPullsBackHeldOrNot) {
  for (const auto strength : {StrengthIs::held, StrengthIs::falling}) {
    const auto back = law_at(point(), {end / 2, end / 2, 0}, strength, end / 8, 0);
    TEST_FLOATING_EQUALITY(back.pull, 25e3 / 4, 1e-14);
    TEST_FLOATING_EQUALITY(back.pull_per_opening, 50e3 / end, 1e-14);
    // One whose opening counts for nothing is rigid with what that has left.
    const auto rigid = law_at(point(), {0, end / 2, 0}, strength, end / 8, 0);
    TEST_EQUALITY(rigid.pull, 25e3);
    TEST_EQUALITY(rigid.pull_per_opening, 0);
  }
}

TEUCHOS_UNIT_TEST(Damage, WhatIsAddedToAGapOpensThePoint) {
  auto open = point();
  open.gap_before = end / 4;
  TEST_FLOATING_EQUALITY(law_at(open, {}, StrengthIs::falling, end / 4, 0).pull, 25e3, 1e-14);
  TEST_FLOATING_EQUALITY(wear(open, {}, StrengthIs::falling, opening(end / 4, -25e3)).damage.opened, end / 2, 1e-14);
}

TEUCHOS_UNIT_TEST(Damage, PointsWearByWhatOpensAndWhatSlips) {
  const auto opened = wear(point(), {}, StrengthIs::falling, opening(end / 2, -25e3));
  TEST_ASSERT(!opened.by_far);
  TEST_EQUALITY(opened.damage.opened, end / 2);
  TEST_EQUALITY(opened.damage.reached, end / 2);
  TEST_EQUALITY(opened.damage.way, 0);
  // 5 um are what stones stretch by under 50 kN: the point weakens within the step, and closes as if sound.
  const auto little = wear(point(), {}, StrengthIs::falling, opening(1e-6, -49e3)).damage;
  TEST_EQUALITY(little.opened, 0);
  TEST_EQUALITY(little.reached, 1e-6);
  // Under 100 kN of pressure half a millimetre of slip leaves 50 kN of cohesion beside 60 kN of friction.
  for (const double shear : {109e3, 111e3}) {
    const auto slipped = wear(point(), {}, StrengthIs::falling, {-1e-9, 0.5e-3, 100e3, shear, stones}).damage;
    TEST_EQUALITY(slipped.opened, 0);
    TEST_EQUALITY(slipped.reached, 0);
    TEST_EQUALITY(slipped.way, shear > 110e3 ? 0.5e-3 : 0.0);
  }
}

TEUCHOS_UNIT_TEST(Damage, NothingIsUndone) {
  const PointDamage before{end / 2, end / 2, 0.5e-3};
  for (const auto strength : {StrengthIs::held, StrengthIs::falling})
    for (const PointLoading& back :
         {opening(end / 8, -3e3), opening(-1e-9, 1e5), PointLoading{end / 8, 1e-4, -3e3, 2e5, stones}}) {
      const auto after = wear(point(), before, strength, back).damage;
      TEST_EQUALITY(after.opened, before.opened);
      TEST_EQUALITY(after.reached, before.reached);
      TEST_EQUALITY(after.way, before.way);
    }
  const SofteningPoint strong{mortar, {}, {}, 0};  // nothing to lose
  TEST_EQUALITY(wear(strong, {}, StrengthIs::falling, {1, 1, -5e4, 1e6, stones}).damage.way, 0);
}

TEUCHOS_UNIT_TEST(Damage, BrittlePointsBreakOffWhereHeldStrengthIsExceeded) {
  for (const bool brittle : {false, true})
    for (const double gap : {0.1 * end, 2 * end}) {
      const auto worn = wear(point(brittle), {}, StrengthIs::held, opening(gap, -50e3));
      TEST_EQUALITY(worn.by_far, (brittle && gap > end));
      TEST_EQUALITY(lost(point(brittle), worn.damage) == 1, (brittle || gap > end));
      TEST_ASSERT(!wear(point(brittle), worn.damage, StrengthIs::held, opening(gap, 0)).by_far);  // lost once
    }
  const auto pressed = wear(point(true), {}, StrengthIs::held, {0, 0, 1e6, 2e5, stones});  // neither opens nor slips
  TEST_EQUALITY(lost(point(true), pressed.damage), 0);
  // While strength falls a brittle point only wears.
  TEST_EQUALITY(wear(point(true), {}, StrengthIs::falling, opening(end / 2, -25e3)).damage.opened, end / 2);
}

TEUCHOS_UNIT_TEST(Damage, WhatTheStepTookIsGivenBack) {
  for (const bool brittle : {false, true}) {
    auto p = point(brittle);
    p.before = {end / 4, 0.1e-3};
    const auto back = give_back(p, {end / 2, 0.6 * end, 0.3e-3});
    TEST_EQUALITY(back.opened, end / 4);
    TEST_EQUALITY(back.reached, 0);
    TEST_EQUALITY(back.way, 0);
    // But what has broken off stays so.
    const auto broken = wear(p, {end / 4, 0, 0}, StrengthIs::held, opening(end / 2, -50e3)).damage;
    TEST_EQUALITY(lost(p, give_back(p, broken)) == 1, brittle);
  }
}

TEUCHOS_UNIT_TEST(Damage, OfManyPointsTheOneThatLostMostTells) {
  const PointLaws whole(3, mortar);
  const std::vector<Softening> rate{point().rate, point().rate, point(true).rate};
  const std::vector<double> opened{end / 4, 0, 0}, slipped{0, 0.2e-3, 0};
  const SofteningPoints points(whole, rate, opened, slipped);
  const auto start = points.at_start();
  TEST_EQUALITY(start.size(), 3);
  TEST_EQUALITY(start[0].opened, end / 4);
  // A half in opening beyond a quarter; 0.7 of a millimetre beyond 0.2; a brittle point does not count.
  const Damage worn{{end / 2, end / 2, 0}, {0, 0, 0.5e-3}, {end, end, 0}};
  TEST_FLOATING_EQUALITY(lost_beyond(points, worn, start), 0.5, 1e-14);
  TEST_FLOATING_EQUALITY(lost_beyond(points, {worn[0], start[1], worn[2]}, start), 0.25, 1e-14);
  TEST_EQUALITY(lost_beyond(points, start, worn), 0);
  const auto given = give_back(points, worn);
  TEST_EQUALITY(lost_beyond(points, given, start), 0);
  TEST_EQUALITY(given[1].way, 0);
  TEST_EQUALITY(given[2].opened, end);
}

}  // namespace
