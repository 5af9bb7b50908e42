// Columns built and taken down course by course, against their closed forms.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "base/error.hpp"
#include "scene/scene_reader.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// A course of 0.25 m of 2000 kg/m3 weighs 4905 Pa; without Poisson's ratio a column is a bar of 10 GPa.
constexpr double height = 0.25, weight = 2000 * 9.81 * height, unit = weight * height / 10e9;
// Newton stops at 1e-8 of the largest force.
constexpr double tolerance = 1e-7;

/// Three courses, one stone wide.
Scene column(SelectionMode mode) {
  Scene scene = wall_scene(3);
  scene.mesh.wall.blocks_per_course = 1;
  scene.materials[0].parameters.poisson_ratio = 0;
  scene.selection.mode = mode;
  scene.loads.resize(1);
  scene.stages = three_stages();
  return scene;
}

/// Largest distance of the vertical displacement at a height y of blocks whose middle is at `middle` from a value.
double wrong(const Solution& s, const Scene& scene, int course, double y, double expected) {
  double worst = 0;
  int found = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    // Blocks are numbered course by course: one, two halves, one.
    const int of_node = s.block_of_node[i] == 0 ? 0 : s.block_of_node[i] < 3 ? 1 : 2;
    if (of_node != course || std::abs(s.position[i][1] - y) > 1e-9) continue;
    worst = std::max(worst, std::abs(s.displacement[i][1] - expected));
    ++found;
  }
  return found == 2 + scene.mesh.wall.cells_along - 1 + (course == 1) ? worst : 1.0;
}

double force_between(const Solution& s, double y) {
  double sum = 0;
  for (const auto& p : s.points)
    if (std::abs(p.position[1] - y) < 1e-9 && std::abs(p.normal[1]) > 0.5) sum += p.normal_force;
  return sum;
}

TEUCHOS_UNIT_TEST(Construction, StonesAreBornWithoutStressOnStonesThatHaveSettled) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    Scene scene = column(mode);
    scene.construction = {{"second", {"course 1", "second", ""}}, {"third", {"course 2", "third", ""}}};
    Experiment built(scene);
    TEST_ASSERT(built.run());
    const auto s = built.solution();
    // What lies on a course when it is born or later compresses it: three, two and one courses, own ones half.
    TEST_COMPARE(wrong(s, scene, 0, height, -2.5 * unit), <, tolerance * unit);
    TEST_COMPARE(wrong(s, scene, 1, height, -2.0 * unit), <, tolerance * unit);  // since its birth
    TEST_COMPARE(wrong(s, scene, 1, 2 * height, -3.5 * unit), <, tolerance * unit);
    TEST_COMPARE(wrong(s, scene, 2, 2 * height, -2.0 * unit), <, tolerance * unit);
    TEST_COMPARE(wrong(s, scene, 2, 3 * height, -2.5 * unit), <, tolerance * unit);  // at once it would be 4.5
    TEST_FLOATING_EQUALITY(force_between(s, height), 2 * weight * 0.5, tolerance);   // 0.5 m wide, 1 m thick
    TEST_FLOATING_EQUALITY(force_between(s, 2 * height), weight * 0.5, tolerance);
    for (const auto& p : s.points) TEST_COMPARE(std::abs(p.gap), <, tolerance * unit);
  }
}

TEUCHOS_UNIT_TEST(Construction, WhatIsNotThereYetHasNoWeightAndNoForce) {
  Scene scene = column(SelectionMode::all);
  scene.construction = {{"later", {"course 2", "third", ""}}};
  scene.stages.resize(1);
  scene.stages.push_back(scene.stages[0]);
  scene.stages[1].name = "third";
  Experiment built(scene);
  TEST_ASSERT(built.advance("first", {{"weight", 1}}));
  const auto s = built.solution();
  TEST_COMPARE(wrong(s, scene, 1, 2 * height, -2.0 * unit), <, tolerance * unit);  // (1.5 + 0.5): two courses
  TEST_COMPARE(wrong(s, scene, 2, 3 * height, 0.0), <=, 0.0);
  TEST_EQUALITY(force_between(s, 2 * height), 0.0);
}

TEUCHOS_UNIT_TEST(Construction, WhatIsTakenAwayLeavesTheRestAsIfItHadNeverBeenThere) {
  for (const auto mode : {SelectionMode::all, SelectionMode::adaptive}) {
    Scene scene = column(mode);
    scene.construction = {{"top", {"course 2", "", "third"}}};
    Experiment taken(scene);
    TEST_ASSERT(taken.run());
    const auto s = taken.solution();
    TEST_COMPARE(wrong(s, scene, 0, height, -1.5 * unit), <, tolerance * unit);
    TEST_COMPARE(wrong(s, scene, 1, 2 * height, -2.0 * unit), <, tolerance * unit);
    TEST_COMPARE(wrong(s, scene, 2, 3 * height, -4.5 * unit), <, tolerance * unit);  // stays where it was
    TEST_FLOATING_EQUALITY(force_between(s, height), weight * 0.5, tolerance);
    TEST_EQUALITY(force_between(s, 2 * height), 0.0);
  }
}

TEUCHOS_UNIT_TEST(Construction, IsRefusedWhereItsStagesMakeNoSense) {
  const auto said = [](const ConstructionParameters& c, SelectionMode mode) {
    Scene scene = column(mode);
    scene.construction = {{"top", c}};
    InputProblems problems("scene");
    check_scene(scene, problems);
    try {
      problems.throw_if_any();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names = [](const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
  };
  const auto adaptive = SelectionMode::adaptive;
  TEST_EQUALITY_CONST(said({"course 2", "first", "third"}, adaptive), "");
  TEST_ASSERT(names(said({"course 2", "frist", ""}, adaptive),
                    "construction > top > appears = \"frist\"\n  is no stage of this scene (did you mean \"first\"?)"));
  TEST_ASSERT(names(said({"course 2", "third", "second"}, adaptive), "must be a stage after \"third\""));
  TEST_ASSERT(names(said({"course 2", "third", ""}, SelectionMode::bonded), "does not go with construction stages"));
}

}  // namespace
