// Settings of a scene reach the methods that a load step uses.
#include "scene/internals.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

Solution wall_with(const Internals& internals) {
  auto scene = wall_scene(16);
  scene.selection.mode = SelectionMode::adaptive;
  scene.internals = internals;
  return solved(scene);
}

TEUCHOS_UNIT_TEST(Internals, PatchesThatAreSwitchedOffSolveNothing) {
  Internals off;
  off.methods.patches.used = false;
  TEST_COMPARE(wall_with({}).sum.local_solves, >, 0);
  TEST_EQUALITY(wall_with(off).sum.local_solves, 0);
}

TEUCHOS_UNIT_TEST(Internals, ChangeCountsAndNoResult) {
  Internals other;
  other.methods.solver.active_sets = false;
  const auto usual = wall_with({}), changed = wall_with(other);
  TEST_INEQUALITY(changed.sum.newton_iterations, usual.sum.newton_iterations);
  TEST_FLOATING_EQUALITY(changed.largest_force(), usual.largest_force(), 1e-6);
}

}  // namespace
