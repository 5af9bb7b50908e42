// The minimum along a direction of a convex, piecewise quadratic function, from its slope.
#include "nonlinear/line_search.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

namespace {

using voussoir::exact_step;

// Bisection of (0, 1] into 2^24 pieces; the middle of the last one is at most half of it away.
constexpr double resolution = 1.0 / (1 << 25);

TEUCHOS_UNIT_TEST(ExactStep, IsFullWhenTheFunctionStillFallsThere) {
  TEST_EQUALITY_CONST(exact_step([](double t) { return -3 + 2 * t; }), 1.0);
  TEST_EQUALITY_CONST(exact_step([](double t) { return -2 + 2 * t; }), 1.0);
}

TEUCHOS_UNIT_TEST(ExactStep, IsFullWhenTheSlopeAtItsEndIsRoundOff) {
  // A Newton step on a quadratic ends at a slope that is zero but for the sums behind it.
  TEST_EQUALITY_CONST(exact_step([](double t) { return t < 1 ? -1e6 * (1 - t) : 1e-6; }), 1.0);
}

TEUCHOS_UNIT_TEST(ExactStep, FindsTheMinimumOfAQuadratic) {
  for (const double minimum : {0.9, 0.5, 0.01, 1e-6})
    TEST_COMPARE(std::abs(exact_step([&](double t) { return 4 * (t - minimum); }) - minimum), <=, resolution);
}

TEUCHOS_UNIT_TEST(ExactStep, FindsTheMinimumBehindKinks) {
  // Points that close on the way make the slope steeper; its root is 0.3 + 0.5 / 11 where two have closed.
  const auto slope = [](double t) { return -1 + t + 10 * std::max(0.0, t - 0.3) + 1e6 * std::max(0.0, t - 0.9); };
  TEST_COMPARE(std::abs(slope(exact_step(slope))), <=, 11 * resolution);
}

TEUCHOS_UNIT_TEST(ExactStep, StopsAtAWall) {
  // A slope that jumps: a minimum at the kink itself.
  TEST_COMPARE(std::abs(exact_step([](double t) { return t < 0.25 ? -1.0 : 1e9; }) - 0.25), <=, resolution);
}

TEUCHOS_UNIT_TEST(ExactStep, IsPositiveHoweverNearTheWall) {
  TEST_COMPARE(exact_step([](double t) { return t > 0 ? 1.0 : -1.0; }), >, 0);
}

TEUCHOS_UNIT_TEST(ExactStep, DoesNotDependOnTheUnitOfTheFunction) {
  const auto slope = [](double t) { return -1 + 3 * t + std::max(0.0, t - 0.2); };
  const double step = exact_step(slope);
  TEST_EQUALITY(exact_step([&](double t) { return 0x1p40 * slope(t); }), step);
  TEST_EQUALITY(exact_step([&](double t) { return 0x1p-40 * slope(t); }), step);
}

}  // namespace
