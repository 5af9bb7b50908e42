// The midpoint rule on one mass at a spring, and the change that gives a wanted energy.
#include "dynamics/midpoint_rule.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace {

using namespace voussoir;

struct Oscillator {
  double mass = 2, stiffness = 50, u = 0.1, v = -0.3;

  /// One step without load; returns what damping took.
  double step(const MidpointRule& rule) {
    const double s = rule.mass_factor() * mass + rule.stiffness_factor() * stiffness;
    const double w = (2 / rule.time_step * mass * v - stiffness * u) / s;
    const double middle = rule.midpoint_velocity(w);
    u = rule.displacement_at_end(u, w);
    v = rule.velocity_at_end(v, w);
    return rule.time_step * middle * middle * (rule.mass_damping * mass + rule.stiffness_damping * stiffness);
  }
  double energy() const { return (mass * v * v + stiffness * u * u) / 2; }
};

// A hundred steps of a few operations each: 1e-12 is a hundred times what their rounding leaves.
TEUCHOS_UNIT_TEST(MidpointRule, KeepsEnergyForAnyTimeStep) {
  for (double time_step : {0.001, 0.1, 10.0}) {
    Oscillator o;
    const double before = o.energy();
    for (int k = 0; k < 100; ++k) o.step({time_step, 0, 0});
    TEST_FLOATING_EQUALITY(o.energy(), before, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(MidpointRule, LosesToDampingWhatItSays) {
  Oscillator o;
  const double before = o.energy();
  double lost = 0;
  for (int k = 0; k < 100; ++k) lost += o.step({0.05, 0.4, 0.01});
  TEST_FLOATING_EQUALITY(o.energy() + lost, before, 1e-12);
  TEST_COMPARE(lost, >, 0.1 * before);
}

// The frequency is omega = 5 1/s: after one period the error falls with the square of the step.
TEUCHOS_UNIT_TEST(MidpointRule, IsOfSecondOrder) {
  const auto error = [](int steps) {
    Oscillator o;
    const double u = o.u;
    for (int k = 0; k < steps; ++k) o.step({2 * 3.14159265358979323846 / 5 / steps, 0, 0});
    return std::abs(o.u - u);
  };
  TEST_FLOATING_EQUALITY(error(100) / error(200), 4.0, 0.02);
}

TEUCHOS_UNIT_TEST(MidpointRule, FindsTheLeastChangeThatGivesAnEnergy) {
  for (double slope : {3.0, -3.0, 0.0}) {
    const double x = least_change(2.0, slope, 0.5);
    TEST_FLOATING_EQUALITY(2 * x * x + slope * x, 0.5, 1e-14);
    TEST_COMPARE(std::abs(x), <=, 0.5);  // the other root is at least as far
    if (slope < 0) TEST_COMPARE(x, <, 0);
  }
  TEST_EQUALITY(least_change(2.0, 3.0, 0.0), 0.0);
  TEST_EQUALITY(least_change(2.0, 4.0, -100.0), -1.0);  // cannot lose that much: as much as can be
}

}  // namespace
