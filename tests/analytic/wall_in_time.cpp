// A wall that is pushed sideways, in time: the energy book with all points selected and with some.
//
// Set-up    xml/wall.xml; its own weight in a load step, then 0.15 g within 30 ms in steps of 1 ms.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "motion.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::vector<std::string> pushed(const std::string& mode) {
  return {"selection/mode=" + mode, "steps/stages/push/duration=0.03", "steps/stages/push/time step=1e-3",
          "selection/largest share=1"};
}

TEUCHOS_UNIT_TEST(WallInTime, ClosesItsBookWhateverIsSelected) {
  for (const char* mode : {"all", "adaptive"}) {
    Motion wall("wall", pushed(mode));
    TEST_ASSERT(wall.run([] {}));
    // 30 steps solved to 1e-11 of the largest force. A preconditioner without the blocks that have no selected point
    // once made energies no numbers.
    TEST_COMPARE(wall.largest_imbalance, <, 1e-9 * wall.largest_energy);
    TEST_COMPARE(wall.least_friction, >, -1e-9 * wall.largest_energy);
    TEST_COMPARE(wall.book().friction(), >, 0);
    TEST_COMPARE(wall.least_gap(), >, -1e-12);  // 1e-6 of the largest displacement
    const auto& selected = wall.state().selected;
    const bool everything = std::count(selected.begin(), selected.end(), 1) == wall.model().points().size();
    TEST_EQUALITY(everything, std::string(mode) == "all");
  }
}

}  // namespace
