// What load steps cost in linear solves and Krylov iterations: a guard against getting slower, in counts that do not
// depend on the machine. solve_counts.csv holds them; count_table.hpp says when a change is one.
#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include "performance/count_table.hpp"
#include "run/simulation.hpp"
#include "scene/scene_reader.hpp"
#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// The same scene with points that are selected as needed.
Scene adaptive(Scene scene) {
  scene.selection.mode = SelectionMode::adaptive;
  return scene;
}

/// An adaptive wall of blocks with 2 x 1 cells.
Scene wall_of_few_cells(int courses) {
  Scene scene = adaptive(wall_scene(courses));
  scene.mesh.wall.cells_along = 2;
  scene.mesh.wall.cells_up = 1;
  return scene;
}

/// A scene of two loads, its weight and one more, applied one after the other.
class TwoSteps {
 public:
  TwoSteps(const Scene& scene, Teuchos::FancyOStream& out) : experiment_(scene), out_(out) {}

  bool weight() { return experiment_.advance({{name(0), 1}}); }
  bool second() { return experiment_.advance({{name(0), 1}, {name(1), 1}}); }
  StepReport last() const { return experiment_.solution().last; }
  /// Whether the last step costs what the table says.
  bool as_in_table(const std::string& row) const {
    const StepReport step = last();
    return test::as_in_table(
        row, {step.newton.newton_iterations, step.newton.krylov_iterations, step.cost.whole, step.newton.local_solves},
        out_);
  }

 private:
  std::string name(int load) const { return experiment_.scene().loads[load].name; }

  Experiment experiment_;
  Teuchos::FancyOStream& out_;
};

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

// Half of the wall slides: only systems that are factored whole can be solved, and not all of them need it.
TEUCHOS_UNIT_TEST(SolveCounts, AWallOf128CoursesPushedAsHardAsItBears) {
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

/// Runs a scene of the bridge to its end and compares its counts.
RunSummary whole_run(const std::string& name, const Scene& scene, Teuchos::FancyOStream& out, bool& success) {
  RunOptions options;
  options.folder = name;
  options.overwrite = true;
  Teuchos::oblackholestream nowhere;
  const RunSummary summary = run(scene, options, Tpetra::getDefaultComm(), nowhere);
  TEST_ASSERT(summary.outcome == Outcome::equilibrium);
  TEST_ASSERT(as_in_table(
      name, {summary.linear_solves, summary.krylov_iterations, summary.factorised_whole, summary.patch_solves}, out));
  return summary;
}

// The main job: its own weight, then the western pier settles and tilts, then the western abutment moves.
TEUCHOS_UNIT_TEST(SolveCounts, TheBridge) {
  whole_run("Clare College Bridge", read_scene(repository("/xml/clare-college-bridge.xml")), out, success);
}

// The bridge in mortar, its own weight and the first millimetre of the pier: cracks that compete, and a selection that
// stays one. Were a rough round solved further than asked it would not arrive, and release every point.
TEUCHOS_UNIT_TEST(SolveCounts, TheBridgeInMortar) {
  Scene scene = read_scene(repository("/xml/clare-college-bridge-mortar.xml"));
  scene.stages.resize(2);
  scene.stages[1].increments = 1;
  scene.stages[1].factors["pier settles"] = 0.25;
  const auto bridge = whole_run("Clare College Bridge in mortar", scene, out, success);
  TEST_ASSERT(bridge.selected_points < bridge.candidate_points / 2);
}

}  // namespace
