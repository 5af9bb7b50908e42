// Energy over ten thousand time steps without friction. 1e-9 is what the program promises: 1e-13 a step, a hundredth of
// what forces are solved to.
//
// Bars      xml/impact-bars.xml in steps of 0.1 microseconds, half of them in contact. Came out at 9e-12 of the energy.
// Arch      xml/bouncing-arch.xml: 20 voussoirs, one second in steps of 0.1 ms. Came out at 1.5e-10.
#include <Teuchos_UnitTestHarness.hpp>

#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

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

TEUCHOS_UNIT_TEST(TenThousandSteps, OfABouncingArchKeepItsEnergy) {
  Motion arch("bouncing-arch", {});
  int steps = 0, bounces = 0;
  bool flying = false;
  TEST_ASSERT(arch.run([&] {
    ++steps;
    const auto& lambda = arch.state().lambda;
    int open = 0;
    for (std::size_t k = 0; k < lambda.size(); k += 2) open += lambda[k] == 0;
    const int points = arch.model().points().size();
    if (flying && open < points / 4) ++bounces;
    flying = flying ? open >= points / 4 : open > points / 2;
  }));
  out << bounces << " bounces, imbalance " << arch.largest_imbalance / arch.largest_energy << "\n";
  TEST_EQUALITY(steps, 10000);
  TEST_COMPARE(bounces, >=, 10);
  TEST_EQUALITY(arch.book().friction(), 0);
  TEST_COMPARE(arch.largest_imbalance, <, 1e-9 * arch.largest_energy);
}

}  // namespace
