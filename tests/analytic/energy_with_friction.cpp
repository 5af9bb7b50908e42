// The energy book of an arch whose joints slide and collide, with time steps from a tenth to a hundred times the
// passage of a wave through a cell.
//
// Set-up    xml/bouncing-arch.xml with friction, thrown sideways at 0.5 m/s. The smallest cell is pi x 4.5 m / 40 =
//           0.353 m long, a wave runs at sqrt(E / (rho (1 - nu^2))) = 2282 m/s: 0.155 ms.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "base/text.hpp"
#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double courant_time = 1.55e-4;  // [s]

struct Sweep {
  double courant;
  int steps;
  int least_closings;  // points that close, half of what was counted
};

TEUCHOS_UNIT_TEST(EnergyWithFriction, IsBookedAtEveryStepWhateverItsSize) {
  for (const auto& [courant, steps, least_closings] :
       {Sweep{0.1, 400, 90}, Sweep{1, 300, 250}, Sweep{10, 300, 500}, Sweep{100, 60, 150}}) {
    const double time_step = courant * courant_time;
    Motion arch("bouncing-arch", {"joints/smooth/friction coefficient=0.6", "initial velocities/thrown up/vx=0.5",
                                  "steps/stages/bouncing/time step=" + number_text(time_step),
                                  "steps/stages/bouncing/duration=" + number_text(steps * time_step)});
    int done = 0, closings = 0, solves = 0;
    auto pressing = arch.state().selected;  // of the step before
    TEST_ASSERT(arch.run([&] {
      ++done;
      solves += arch.report.step.newton.newton_iterations;
      for (std::size_t k = 0; k < pressing.size(); ++k) {
        const bool presses = arch.state().lambda[2 * k] > 0;
        closings += presses && !pressing[k];
        pressing[k] = presses;
      }
    }));
    out << courant << ": " << done << " steps, " << solves << " solves, " << closings << " closings, friction took "
        << arch.book().friction() / arch.largest_energy << ", imbalance "
        << arch.largest_imbalance / arch.largest_energy << "\n";
    TEST_EQUALITY(done, steps);
    TEST_COMPARE(closings, >=, least_closings);
    TEST_COMPARE(arch.book().friction(), >, 0.05 * arch.largest_energy);
    // What the program promises; forces to 1e-11 give 1e-11.
    TEST_COMPARE(arch.largest_imbalance, <, 1e-8 * arch.largest_energy);
    TEST_COMPARE(arch.least_friction, >=, -1e-12 * arch.largest_energy);  // round-off of points that stick
  }
}

}  // namespace
