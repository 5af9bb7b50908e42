// What time steps cost in linear solves while joints open and slip.
#include <Teuchos_UnitTestHarness.hpp>

#include "analytic/motion.hpp"
#include "performance/count_table.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// The first 0.4 s of xml/wall-shaken.xml at 6 g, in 100 steps, every point resolved. Factors stay where resistances do:
// more than a third of the solves use some again.
TEUCHOS_UNIT_TEST(SolvesInTime, OfAShakenWall) {
  Motion wall("wall-shaken", {"selection/mode=all", "loads/earthquake/scale=40", "steps/stages/shaking/duration=0.4",
                              "steps/stages/shaking/time step=4e-3"});
  Counts counts;
  SystemCost cost;
  TEST_ASSERT(wall.run([&] {
    const auto& step = wall.report.step;
    counts.add(
        {step.newton.newton_iterations, step.newton.krylov_iterations, step.cost.whole, step.newton.local_solves});
    cost.add(step.cost);
  }));
  out << cost.factorised << " factorised, " << cost.reused << " reused\n";
  TEST_ASSERT(as_in_table("W shaken by 6 g", counts, out));
  TEST_COMPARE(3 * cost.reused, >, counts.solves);
}

}  // namespace
