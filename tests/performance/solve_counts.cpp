// What load steps cost in linear solves and Krylov iterations: a guard against getting slower, in counts that do not
// depend on the machine. solve_counts.csv holds them; count_table.hpp says when a change is one.
#include <Teuchos_UnitTestHarness.hpp>

#include "performance/counted_scenes.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// Bytes per unknown of H, of the factors of blocks and of their motions: 198 + 127 + 84 on W(16), less on arches.
constexpr double most_bytes = 440;

void check(const std::string& name, const Scene& scene, Teuchos::FancyOStream& out, bool& success) {
  TwoSteps steps(scene, out);
  for (const bool both : {false, true}) {
    TEST_ASSERT(both ? steps.second() : steps.weight());
    TEST_ASSERT(steps.as_in_table(name + (both ? " second step" : " weight")));
    const StepReport step = steps.last();
    // Every point is released in the end, or so much is wrong that the decreases tell: nothing is left to estimate.
    TEST_EQUALITY(step.estimate_solves, 0);
    const double unknowns = 2.0 * static_cast<double>(step.largest_clusters);
    const auto per_unknown = [&](long long bytes) { return static_cast<double>(bytes) / unknowns; };
    const double matrix = per_unknown(step.cost.matrix_bytes), blocks = per_unknown(step.cost.block_bytes),
                 motions = per_unknown(step.cost.motion_bytes);
    out << step.cost.factorised << " factorised, " << step.cost.reused << " reused, " << matrix << " + " << blocks
        << " + " << motions << " bytes per unknown\n";
    TEST_COMPARE(step.cost.factorised + step.cost.reused, <=, step.newton.newton_iterations);
    TEST_COMPARE(matrix + blocks + motions, <=, most_bytes);
  }
}

// Every point from a cold start; then a settlement of 5 mm or 0.15 g in one step. Stones of W(32) hang by friction
// between others that part, so that active sets alone do not arrive.
TEUCHOS_UNIT_TEST(SolveCounts, AnArchOf61Voussoirs) { check("A(61)", arch_scene(61), out, success); }
TEUCHOS_UNIT_TEST(SolveCounts, AnArchOf121Voussoirs) { check("A(121)", arch_scene(121), out, success); }
TEUCHOS_UNIT_TEST(SolveCounts, AWallOf16Courses) { check("W(16)", wall_scene(16), out, success); }
TEUCHOS_UNIT_TEST(SolveCounts, AWallOf32Courses) { check("W(32)", wall_scene(32), out, success); }

TEUCHOS_UNIT_TEST(SolveCounts, AWallOf64CoursesAsFarAsItIsSelected) {
  TwoSteps steps(adaptive(wall_scene(64)), out);
  TEST_ASSERT(steps.weight());
  TEST_ASSERT(steps.as_in_table("W(64) adaptive weight"));
}

// Only the solution is estimated: neither the bonded wall, whose decreases tell that it will not do, nor the rough
// round, where what the release leaves tells that it will.
TEUCHOS_UNIT_TEST(SolveCounts, AWallOf64CoursesOfWhichLittleParts) {
  TwoSteps steps(wall_of_few_cells(64), out);
  TEST_ASSERT(steps.weight());
  TEST_ASSERT(steps.as_in_table("W(64) of few cells weight"));
  TEST_EQUALITY(steps.last().estimate_solves, 1);
}

// In a later step too a first look is rough where it releases points: all of the first round but what it shows is
// thrown away.
TEUCHOS_UNIT_TEST(SolveCounts, ALaterStepLooksRoughlyFirst) {
  TwoSteps steps(adaptive(wall_scene(16)), out);
  TEST_ASSERT(steps.weight());
  TEST_ASSERT(steps.second());
  TEST_COMPARE(steps.last().selection_rounds, >, 0);
  TEST_ASSERT(steps.as_in_table("W(16) adaptive second step"));
}

// A settlement reaches most joints: a round that would be thrown away is not solved.
TEUCHOS_UNIT_TEST(SolveCounts, SelectingCostsNoMoreThanEveryPointWhereMostAreReached) {
  check("A(61) adaptive", adaptive(arch_scene(61)), out, success);
}

// Nothing to choose, nothing to correct: every step of a bonded structure is one linear solve.
TEUCHOS_UNIT_TEST(SolveCounts, ABondedWall) {
  Scene scene = wall_scene(16);
  scene.selection.mode = SelectionMode::bonded;
  TwoSteps steps(scene, out);
  for (const bool both : {false, true}) {
    TEST_ASSERT(both ? steps.second() : steps.weight());
    TEST_EQUALITY(steps.last().newton.newton_iterations, 1);
  }
}

// The main job: its own weight, then the western pier settles and tilts, then the western abutment moves.
TEUCHOS_UNIT_TEST(SolveCounts, TheBridge) {
  RunSummary bridge;
  TEST_ASSERT(whole_run("Clare College Bridge", read_scene(repository("/xml/clare-college-bridge.xml")), out, bridge));
}

}  // namespace
