// Work along a step that changes its sign at a kink, as where a stone meets its neighbour, is known by heart.
#include "nonlinear/driven_share.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

namespace {

using voussoir::driven_share;

constexpr double left = 0.5, round_off = 1e-12;

TEUCHOS_UNIT_TEST(DrivenShare, AStepThatIsDrivenToItsEndIsTakenInFull) {
  TEST_EQUALITY(driven_share([](double t) { return 1 - t; }, left), 1);
  TEST_EQUALITY(driven_share([](double t) { return 1 + t; }, left), 1);
  TEST_EQUALITY(driven_share([](double) { return 0; }, left), 1);
}

TEUCHOS_UNIT_TEST(DrivenShare, HalfOfTheWorkMayBeAgainstItsEnd) {
  TEST_EQUALITY(driven_share([](double t) { return 1 - 1.4 * t; }, left), 1);
  TEST_FLOATING_EQUALITY(driven_share([](double t) { return 1 - 1.6 * t; }, left), 1 / 1.6, round_off);
}

TEUCHOS_UNIT_TEST(DrivenShare, EndsWhereAStoneMeetsItsNeighbourHoweverNearThatIs) {
  for (const double neighbour : {0.3, 1e-3, 1e-9}) {
    const auto work = [&](double t) { return t < neighbour ? 1 : 1 - (t - neighbour) * 1e3 / neighbour; };
    TEST_FLOATING_EQUALITY(driven_share(work, left), neighbour * 1.001, 1e-6);
  }
}

// Work that is next to linear between kinks, as forces of stiff stones are, is looked at a dozen times.
TEUCHOS_UNIT_TEST(DrivenShare, LooksAtFewPlaces) {
  for (const double kink : {0.02, 0.5, 0.9}) {
    int places = 0;
    const auto work = [&](double t) {
      ++places;
      return 1 - t - 8 * std::max(0.0, t - kink) - 1e-3 * t * t;
    };
    const double end = driven_share(work, left);
    TEST_COMPARE(std::abs(work(end)), <=, 1e-14);
    TEST_COMPARE(places, <=, 20);
  }
}

TEUCHOS_UNIT_TEST(DrivenShare, GoesTheOtherWayWhereItsStartIsWorkedAgainst) {
  const auto away = [](double t) { return -1 - 10 * t; };
  TEST_FLOATING_EQUALITY(driven_share(away, left), -0.1, round_off);
  // Against it, but less and less: its end is what it looks for.
  TEST_EQUALITY(driven_share([](double t) { return -1 + t; }, left), 1);
  // Nothing meets it the other way.
  TEST_EQUALITY(driven_share([](double t) { return t > 0 ? -1 - 10 * t : -1.0; }, left), -1);
}

}  // namespace
