// What a point takes as it cracks is the integral of the law's own force along its way.
#include "joints/crack_work.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <vector>

namespace {

using namespace voussoir;

constexpr double infinite = std::numeric_limits<double>::infinity();
const PointLaw mortar{0.6, 1e5, 5e4};       // [-, N, N]
constexpr double opening = 10, shear = 50;  // [J]
constexpr double end = 2 * opening / 5e4;   // [m] opening that takes all, where strength falls linearly

Softening softening(bool exponential) { return {mortar.tension / opening, mortar.cohesion / shear, exponential}; }

/// Where a point gets to when it has opened and slipped so far, and what its law bears there.
CrackEnd at(double gap, double slipped) { return {{std::max(0.0, gap), slipped}, gap, 0}; }

constexpr int steps = 200000;  // of a way

struct Sum {
  double pull = 0, cohesion = 0;  ///< [J]
};

/// The same in many small steps of the law that the solver has, each with the mean of its forces.
Sum by_quadrature(const PointLaw& law, const Softening& s, const CrackEnd& from, const CrackEnd& to) {
  Sum sum;
  const double opens = to.gap - from.gap, slips = to.wear.slipped - from.wear.slipped;
  const auto force = [&](double share) {
    const double gap = from.gap + share * opens;
    const JointWear before{from.wear.opened, from.wear.slipped + share * slips};
    const auto now = weaken(law, s, before, gap, 0);
    const double pull = gap > 0 ? now.pull : std::max(0.0, -from.normal - share * (to.normal - from.normal));
    return Sum{gap > 0 ? pull : 0.0, friction_bound({law.friction, now.law.cohesion, 0}, -pull)};
  };
  Sum last = force(0);
  for (int k = 1; k <= steps; ++k) {
    const Sum next = force(static_cast<double>(k) / steps);
    sum.pull += (last.pull + next.pull) / 2 * opens / steps;
    sum.cohesion += (last.cohesion + next.cohesion) / 2 * slips / steps;
    last = next;
  }
  return sum;
}

TEUCHOS_UNIT_TEST(CrackWork, EachModeAloneTakesItsEnergyInAnySteps) {
  for (const bool exponential : {false, true}) {
    const auto s = softening(exponential);
    const std::vector<std::vector<double>> ways{{1}, {3e-5, 1e-4, 1.1e-4, 5e-4, 1}, {1e-4, 2e-5, -1e-5, 3e-4, 0, 1}};
    for (const auto& way : ways) {
      double opened = 0, slipped = 0, held = 0;
      CrackEnd open, slide;
      for (const double to : way) {
        const CrackEnd next{{std::max(open.wear.opened, to), 0}, to, 0};
        const auto work = crack_work(mortar, s, open, next);
        opened += work.fracture;
        held += work.pull - work.fracture;
        open = next;
        TEST_FLOATING_EQUALITY(held + 1, held_energy(mortar, s, open.wear, open.gap) + 1, 1e-11);
        const CrackEnd on{{0, std::max(slide.wear.slipped, to)}, 0, 0};
        slipped += crack_work(mortar, s, slide, on).fracture;
        slide = on;
      }
      TEST_FLOATING_EQUALITY(opened, opening, 1e-11);
      TEST_FLOATING_EQUALITY(slipped, shear, 1e-11);
    }
  }
}

TEUCHOS_UNIT_TEST(CrackWork, IsTheIntegralOfTheLawOnAnyWay) {
  const CrackEnd closed{{0, 0}, -1e-6, 2e4}, pulled{{0, 0}, 0, -3e4}, opened{{1e-4, 5e-5}, 2e-5, 0};
  const std::vector<std::pair<CrackEnd, CrackEnd>> ways{{closed, at(0.5 * end, 2e-4)},
                                                        {closed, at(3 * end, 4e-3)},
                                                        {pulled, {{0, 3e-4}, 0, -1e4}},
                                                        {pulled, at(2e-4, 3e-4)},
                                                        {opened, at(3e-4, 1e-3)},
                                                        {opened, {{1e-4, 4e-4}, 8e-5, 0}},
                                                        {at(2e-4, 1e-4), {{2e-4, 6e-4}, -1e-5, 1e4}}};
  for (const bool exponential : {false, true})
    for (const double friction : {0.6, 3.0, infinite})
      for (const auto& [from, to] : ways) {
        const PointLaw law{friction, mortar.cohesion, mortar.tension};
        const auto work = crack_work(law, softening(exponential), from, to);
        const Sum sum = by_quadrature(law, softening(exponential), from, to);
        // Forces jump where the point opens: one step of the sum is off by that.
        const double opens = std::abs(to.gap - from.gap), slips = to.wear.slipped - from.wear.slipped;
        TEST_COMPARE(std::abs(work.pull - sum.pull), <=, law.tension * opens / steps + 1e-9 * opening);
        TEST_COMPARE(std::abs(work.cohesion - sum.cohesion), <=, law.cohesion * slips / steps + 1e-9 * shear);
        const auto held = [&](const CrackEnd& e) { return held_energy(law, softening(exponential), e.wear, e.gap); };
        TEST_COMPARE(std::abs(work.fracture - (work.pull + work.cohesion - held(to) + held(from))), <, 1e-9 * opening);
        TEST_COMPARE(work.fracture, >=, 0);
      }
}

TEUCHOS_UNIT_TEST(CrackWork, PartsOfAWayTakeWhatItTakes) {
  for (const bool exponential : {false, true}) {
    const auto s = softening(exponential);
    const CrackEnd to = at(0.8 * end, 6e-4);
    for (const int parts : {4, 40, 800}) {
      double sum = 0;
      CrackEnd from;
      for (int k = 1; k <= parts; ++k) {
        const CrackEnd next = at(to.gap * k / parts, to.wear.slipped * k / parts);
        sum += crack_work(mortar, s, from, next).fracture;
        from = next;
      }
      TEST_FLOATING_EQUALITY(sum, crack_work(mortar, s, {}, to).fracture, 1e-9);
    }
  }
}

// As where stones give way by more under the force of the point: nothing is lost, and later nothing is counted twice.
TEUCHOS_UNIT_TEST(CrackWork, AnOpeningThatLeavesNoDamageIsGivenBack) {
  for (const bool exponential : {false, true}) {
    const auto s = softening(exponential);
    const CrackEnd sound, unnoticed{{0, 0}, 0.1 * end, 0};
    TEST_EQUALITY(crack_work(mortar, s, sound, unnoticed).fracture, 0);
    TEST_EQUALITY(crack_work(mortar, s, unnoticed, sound).fracture, 0);
    TEST_COMPARE(held_energy(mortar, s, unnoticed.wear, unnoticed.gap), >, 0);
    TEST_FLOATING_EQUALITY(crack_work(mortar, s, unnoticed, at(1, 0)).fracture, opening, 1e-11);
  }
}

TEUCHOS_UNIT_TEST(CrackWork, WhatBreaksOffTakesAllItHad) {
  const auto s = softening(false);
  for (const double gap : {-1e-6, 0.2 * end}) {  // damaged beyond where it stands
    const CrackEnd broken{{2 * end, 0}, gap, 0};
    const auto work = crack_work(mortar, s, {}, broken);
    TEST_FLOATING_EQUALITY(work.fracture, opening, 1e-11);
    TEST_FLOATING_EQUALITY(work.pull, opening, 1e-11);
    TEST_EQUALITY(crack_work(mortar, s, broken, at(3 * end, 0)).fracture, 0);
  }
}

TEUCHOS_UNIT_TEST(CrackWork, PulledPointsSlideOnWhatThePullLeavesOfTheirCohesion) {
  const auto s = softening(false);
  const CrackEnd from{{0, 0}, 0, -3e4}, to{{0, 2e-4}, 0, -3e4};
  // C falls from 100 to 80 kN on the way; the pull of 30 kN takes 18 kN of it.
  TEST_FLOATING_EQUALITY(crack_work(mortar, s, from, to).cohesion, (90e3 - 18e3) * 2e-4, 1e-12);
  TEST_EQUALITY(crack_work({4.0, 1e5, 5e4}, s, from, to).cohesion, 0);
}

TEUCHOS_UNIT_TEST(CrackWork, OfStrengthWithoutEndNothingIsCounted) {
  const PointLaw glued{0.6, 1e5, infinite};
  const Softening s{0, glued.cohesion / shear, false};
  const double all = 2 * shear / glued.cohesion;
  TEST_EQUALITY(held_energy(glued, s, {0, 0.5 * all}, 1), 0);
  TEST_FLOATING_EQUALITY(crack_work(glued, s, {}, {{0, 2 * all}, 1e-3, 0}).fracture, shear, 1e-11);
  TEST_EQUALITY(crack_work({0.6, infinite, infinite}, {}, {}, {{0, 1}, 1, 0}).fracture, 0);
}

TEUCHOS_UNIT_TEST(CrackWork, ScalesWithUnits) {
  const CrackEnd from{{1e-4, 5e-5}, 2e-5, 0}, to = at(3e-4, 1e-3);
  const auto si = crack_work(mortar, softening(true), from, to);
  const auto mm = [](CrackEnd e) { return CrackEnd{{1024 * e.wear.opened, 1024 * e.wear.slipped}, 1024 * e.gap, 0}; };
  auto s = softening(true);
  s.per_opening /= 1024, s.per_slip /= 1024;
  TEST_FLOATING_EQUALITY(crack_work(mortar, s, mm(from), mm(to)).fracture, 1024 * si.fracture, 1e-14);
}

}  // namespace
