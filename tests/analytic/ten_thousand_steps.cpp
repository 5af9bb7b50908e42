// Energy over ten thousand time steps of two bars that collide without friction: xml/impact-bars.xml in steps of 0.1
// microseconds, of which half see the bars in contact. Came out at 9e-12 of the energy.
#include <Teuchos_UnitTestHarness.hpp>

#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// 1e-9 is what the program promises: 1e-13 a step, a hundredth of what forces are solved to.
TEUCHOS_UNIT_TEST(TenThousandSteps, OfTwoBarsKeepTheirEnergy) {
  Motion bars("impact-bars", {"steps/stages/impact/time step=1e-7"});
  int steps = 0;
  double pressing = 0;
  TEST_ASSERT(bars.run([&] {
    ++steps;
    pressing += bars.normal_force() > 0;
  }));
  TEST_EQUALITY(steps, 10000);
  TEST_COMPARE(pressing, >, 5000);
  TEST_COMPARE(bars.largest_imbalance, <, 1e-9 * bars.largest_energy);
}

}  // namespace
