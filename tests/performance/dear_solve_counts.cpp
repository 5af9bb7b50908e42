// As solve_counts.cpp, of scenes that take half a minute and more.
#include <Teuchos_UnitTestHarness.hpp>

#include "performance/counted_scenes.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Half of the wall slides: only systems that are factored whole can be solved, and not all of them need it.
TEUCHOS_UNIT_TEST(DearSolveCounts, AWallOf128CoursesPushedAsHardAsItBears) {
  TwoSteps steps(wall_of_few_cells(128), out);
  TEST_ASSERT(steps.weight());
  TEST_EQUALITY(steps.last().cost.whole, 0);
  TEST_ASSERT(steps.second());
  TEST_ASSERT(steps.as_in_table("W(128) of few cells pushed"));
  const StepReport step = steps.last();
  const double bytes = static_cast<double>(step.cost.whole_bytes) / (2.0 * static_cast<double>(step.largest_clusters));
  out << bytes << " bytes per unknown of whole factors\n";
  TEST_COMPARE(step.cost.whole, >, 0);
  TEST_COMPARE(step.cost.whole, <, step.newton.newton_iterations);
  TEST_COMPARE(bytes, <=, 1800);
}

// The bridge in mortar, its own weight and the first millimetre of the pier: cracks that compete, and a selection that
// stays one. Were a rough round solved further than asked it would not arrive, and release every point.
TEUCHOS_UNIT_TEST(DearSolveCounts, TheBridgeInMortar) {
  Scene scene = read_scene(repository("/xml/clare-college-bridge-mortar.xml"));
  scene.stages.resize(2);
  scene.stages[1].increments = 1;
  scene.stages[1].factors["pier settles"] = 0.25;
  RunSummary bridge;
  TEST_ASSERT(whole_run("Clare College Bridge in mortar", scene, out, bridge));
  TEST_ASSERT(bridge.selected_points < bridge.candidate_points / 2);
}

// 200 stones of tetrahedra in all shapes. Half of the points open and a sixth slips: one round selects them all.
TEUCHOS_UNIT_TEST(DearSolveCounts, TheCrossVault) {
  RunSummary vault;
  TEST_ASSERT(whole_run("Cross vault", read_scene(repository("/xml/cross-vault.xml")), out, vault));
  TEST_EQUALITY(vault.selection_rounds, 1);
}

}  // namespace
