// All points selected from a cold start: walls and arches on which plain active sets cycle. What is checked is the
// definition of contact with friction, from displacement and forces, not what the solver says of itself.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.6;

void check(const Scene& scene, Teuchos::FancyOStream& out, bool& success) {
  Experiment experiment(scene);
  for (const auto& stage : {1, 2}) {
    const auto& first = scene.loads[0].name;
    const auto& second = scene.loads[1].name;
    TEST_ASSERT(stage == 1 ? experiment.advance({{first, 1}}) : experiment.advance({{first, 1}, {second, 1}}));
    const auto s = experiment.solution();
    TEST_EQUALITY(s.selected(), static_cast<long long>(s.points.size()));
    const auto e = contact_errors(s, friction);
    out << s.last.newton.newton_iterations << " linear solves, equilibrium " << e.equilibrium << ", penetration "
        << e.penetration << " m, pressure at gaps " << e.pressure_at_gap << ", outside the cone " << e.outside_cone
        << "\n";
    // Forces to 1e-8 of the largest; that of the test may differ a little from the solver's measure of it.
    TEST_COMPARE(e.equilibrium, <=, 2e-8);
    TEST_COMPARE(e.tension, <=, 1e-12);
    TEST_COMPARE(e.pressure_at_gap, <=, 2e-8);
    TEST_COMPARE(e.outside_cone, <=, 1e-8);
    TEST_COMPARE(e.penetration, <=, 1e-10);
    // A point that may not slip slips by what 1e-8 of the largest force bends, less than the penetration allowed.
    TEST_COMPARE(e.slip_inside_cone, <=, 1e-10);
    TEST_COMPARE(e.slip_along_force, <=, 1e-10);
  }
}

TEUCHOS_UNIT_TEST(ColdStart, Arch15) { check(arch_scene(15), out, success); }
TEUCHOS_UNIT_TEST(ColdStart, Arch31) { check(arch_scene(31), out, success); }
TEUCHOS_UNIT_TEST(ColdStart, Arch61) { check(arch_scene(61), out, success); }
TEUCHOS_UNIT_TEST(ColdStart, Wall8) { check(wall_scene(8), out, success); }
TEUCHOS_UNIT_TEST(ColdStart, Wall16) { check(wall_scene(16), out, success); }
TEUCHOS_UNIT_TEST(ColdStartOfALargeWall, Wall32) { check(wall_scene(32), out, success); }

// A stage that moves nothing: the state must stay, whatever the solver remembers of the steps before.
TEUCHOS_UNIT_TEST(ColdStart, NothingMovesNothing) {
  Experiment experiment(arch_scene(31));
  const auto& scene = experiment.scene();
  const std::map<std::string, double> all{{scene.loads[0].name, 1}, {scene.loads[1].name, 1}};
  TEST_ASSERT(experiment.advance(all));
  const auto before = experiment.solution();
  TEST_ASSERT(experiment.advance(all));
  TEST_EQUALITY(experiment.solution().last.newton.newton_iterations, 0);
  TEST_EQUALITY(experiment.solution().largest_displacement(), before.largest_displacement());
}

}  // namespace
