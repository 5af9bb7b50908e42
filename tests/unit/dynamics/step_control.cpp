// Which time step next. Steps are duration / whole number / power of two: comparisons to 1e-12 see any other.
#include "dynamics/step_control.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

namespace {

using namespace voussoir;

constexpr double courant = 1e-3, tolerance = 0.02;

TEUCHOS_UNIT_TEST(StepControl, DividesAStageIntoStepsNoLongerThanTheUserWants) {
  TimeStepLevel now, other;
  const StepControl control(now, 1.0, 0.3, courant, 100 * courant, tolerance, 3);
  TEST_FLOATING_EQUALITY(control.time_step(), 0.25, 1e-12);
  const StepControl exact(other, 1.0, 0.1, courant, 100 * courant, tolerance, 3);
  TEST_FLOATING_EQUALITY(exact.time_step(), 0.1, 1e-12);
}

TEUCHOS_UNIT_TEST(StepControl, LeavesAFixedStepAloneWhateverTheError) {
  TimeStepLevel now;
  StepControl control(now, 1.0, 0.1, courant, 100 * courant, tolerance, 3);
  for (int k = 1; k <= 10; ++k) TEST_ASSERT(!control.accept(k % 2 == 0 ? 1.0 : 0.0, 0.1 * k));
}

TEUCHOS_UNIT_TEST(StepControl, HalvesAFailedStepAndReturnsToIt) {
  TimeStepLevel now;
  StepControl control(now, 1.0, 0.1, courant, 100 * courant, tolerance, 2);
  TEST_ASSERT(control.halve());
  TEST_ASSERT(control.halve());
  TEST_ASSERT(!control.halve());
  TEST_FLOATING_EQUALITY(control.time_step(), 0.025, 1e-12);
  double reached = 0;
  for (int k = 0; k < 100 && reached < 1 - 1e-9; ++k) {
    reached += control.time_step();
    control.accept(0, reached);
  }
  TEST_FLOATING_EQUALITY(control.time_step(), 0.1, 1e-12);
  TEST_FLOATING_EQUALITY(reached, 1.0, 1e-12);  // on its raster all the way
}

TEUCHOS_UNIT_TEST(StepControl, GrowsFromTheCourantTimeAndShrinksToIt) {
  TimeStepLevel now;
  StepControl control(now, 10.0, 0, courant, 100 * courant, tolerance, 3);
  TEST_COMPARE(control.time_step(), <=, courant * (1 + 1e-12));
  double reached = 0;
  for (int k = 0; k < 2000 && reached < 5; ++k) {
    reached += control.time_step();
    control.accept(0, reached);
  }
  TEST_FLOATING_EQUALITY(control.time_step(), 100 * courant, 1e-12);
  for (int k = 0; k < 20; ++k) {
    reached += control.time_step();
    control.accept(1.0, reached);
  }
  TEST_COMPARE(control.time_step(), <=, courant * (1 + 1e-12));
  TEST_COMPARE(control.time_step(), >, courant / 2);
}

// A load varies within 4 ms from 0.3 s on: steps are long before it, and see it in it.
TEUCHOS_UNIT_TEST(StepControl, LooksAheadToWhatLoadsDo) {
  TimeStepLevel now;
  StepControl control(now, 1.0, 0, courant, 100 * courant, tolerance, 3);
  const auto resolution = [](double from, double to) { return from < 0.304 && to > 0.3 ? 2e-3 : 1.0; };
  double reached = 0, within = 0, before = 0;
  while (reached < 0.304) {
    control.look_ahead(reached, resolution);
    const double step = control.time_step();
    if (reached + step > 0.3 + 1e-9) within = std::max(within, step);
    if (reached + step < 0.3) before = std::max(before, step);
    reached += step;
    control.accept(0, reached);
  }
  TEST_COMPARE(within, <=, 2e-3);
  TEST_COMPARE(within, >, courant / 2);
  TEST_COMPARE(before, >, 10e-3);
  TimeStepLevel given;
  StepControl fixed(given, 1.0, 0.1, courant, 100 * courant, tolerance, 3);
  fixed.look_ahead(0.25, resolution);
  TEST_FLOATING_EQUALITY(fixed.time_step(), 0.1, 1e-12);
}

TEUCHOS_UNIT_TEST(StepControl, GoesOnWithTheTimeStepItHadWhenItWasLeft) {
  TimeStepLevel now;
  StepControl left(now, 1.0, 0.1, courant, 100 * courant, tolerance, 3);
  left.halve();
  TEST_EQUALITY(StepControl(now, 1.0, 0.1, courant, 100 * courant, tolerance, 3).time_step(), left.time_step());
}

// A scene may change its tolerances before a restart.
TEUCHOS_UNIT_TEST(StepControl, HalvedMoreOftenThanIsAllowedNowHalvesNoMore) {
  TimeStepLevel now;
  StepControl patient(now, 1.0, 0.1, courant, 100 * courant, tolerance, 3);
  for (int k = 0; k < 2; ++k) TEST_ASSERT(patient.halve());
  TEST_ASSERT(!StepControl(now, 1.0, 0.1, courant, 100 * courant, tolerance, 1).halve());
  TEST_ASSERT(patient.halve());
}

}  // namespace
