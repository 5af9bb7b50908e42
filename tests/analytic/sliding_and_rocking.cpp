// A block that slides to rest, and a column that rocks.
//
// Source    friction: distance v^2 / (2 mu g), friction takes the kinetic energy. Rocking: G. W. Housner,
//           Bull. Seismol. Soc. Am. 53 (1963) 403-417: 2/p arccosh(1/(1 - theta0/alpha)) is half a period,
//           p^2 = 3 g / (4 R).
// Set-up    xml/sliding-block.xml, xml/rocking-column.xml: a static start, then a push.
// Came out  distance 0.2552 m for 0.2548 m; half a period 0.2084 s. The program knows small displacements only, where
//           the moment that brings the column back does not fall with its angle: 2/p sqrt(2 theta0/alpha) = 0.2091 s
//           for rigid stone, which Housner's 0.2108 s tends to for small angles.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double gravity = 9.81;  // [m/s2]

TEUCHOS_UNIT_TEST(SlidingBlock, ComesToRestWhereFrictionHasTakenItsEnergy) {
  Motion block("sliding-block", {"selection/mode=all"});
  TEST_ASSERT(block.run([] {}));
  const double slid = block.displacement(1, [](const auto&) { return true; })[0];
  // The block vibrates while it slides, and damping takes 2e-4 of the energy; measured 0.15 %.
  TEST_FLOATING_EQUALITY(slid, 1 / (2 * 0.2 * gravity), 0.005);
  TEST_FLOATING_EQUALITY(block.book().friction(), 500.0, 0.005);
  TEST_COMPARE(block.report.kinetic, <, 1e-4 * 500);
  TEST_COMPARE(block.largest_imbalance, <, 1e-8 * block.largest_energy);
  // Solved to 1e-11 of forces of 1e4 N over slips of 1 mm: 1e-10 J.
  TEST_COMPARE(block.least_friction, >, -1e-9);
}

// Courant time 0.045 ms: steps from a tenth of it to a hundred times.
TEUCHOS_UNIT_TEST(SlidingBlock, NeverGainsEnergyByFrictionWhateverTheTimeStep) {
  for (const char* time_step : {"4.5e-6", "45e-6", "0.45e-3", "4.5e-3"}) {
    const double value = std::stod(time_step);
    Motion block("sliding-block",
                 {"selection/mode=all", "joints/dry/friction coefficient=0.6", "steps/time/stiffness damping=0",
                  "steps/stages/sliding/time step=" + std::string(time_step),
                  "steps/stages/sliding/duration=" + std::to_string(20 * value)});
    TEST_ASSERT(block.run([] {}));
    TEST_COMPARE(block.least_friction, >, -1e-9);
    TEST_COMPARE(block.book().friction(), >, 0);
    TEST_COMPARE(block.largest_imbalance, <, 1e-8 * block.largest_energy);
    TEST_COMPARE(block.least_gap(), >, -1e-11);
  }
}

TEUCHOS_UNIT_TEST(RockingColumn, ComesBackAfterHalfItsPeriod) {
  Motion column("rocking-column", {"selection/mode=all", "steps/stages/rocking/duration=0.23"});
  const double b = 0.2, h = 2, alpha = std::atan(b / h), p = std::sqrt(3 * gravity / (4 * std::hypot(b, h)));
  double largest = 0, back = 0, before = 0, before_time = 0;
  TEST_ASSERT(column.run([&] {
    const double angle = -column.displacement(1, [](const auto& x) { return x[1] > 3.999; })[0] / 4;
    if (back == 0 && angle <= 0 && column.time > 0.05)
      back = before_time + (column.time - before_time) * before / (before - angle);
    largest = std::max(largest, angle);
    before = angle;
    before_time = column.time;
  }));
  const double share = largest / alpha;
  // The push of 0.03795 rad/s leads to a fiftieth of alpha; the column bends and its base gives way a little.
  TEST_FLOATING_EQUALITY(share, 0.02, 0.02);
  TEST_FLOATING_EQUALITY(back, 2 / p * std::sqrt(2 * 0.02), 0.005);
  // What small displacements leave out of Housner's period is 5/12 of theta0/alpha, 0.8 %.
  TEST_FLOATING_EQUALITY(back, 2 / p * std::acosh(1 / (1 - 0.02)), 0.015);
  TEST_COMPARE(column.largest_imbalance, <, 1e-8 * column.largest_energy);
  TEST_COMPARE(column.least_friction, >, -1e-9);
}

}  // namespace
