// Tied points are contact points that were not asked: selecting more of them leads to the same solution, or a lower
// energy; infinite strength leads back to the continuum.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Displacement of an adaptive run that releases every violating point, against all points selected.
double difference_at_zero_tolerance(Scene scene, Teuchos::FancyOStream& out) {
  scene.selection.mode = SelectionMode::all;
  const auto all = solved(scene);
  scene.selection.mode = SelectionMode::adaptive;
  scene.selection.error_tolerance = 0;
  const auto adaptive = solved(scene);
  const double d = difference(adaptive, all);
  out << adaptive.selected() << " of " << all.selected() << " points selected, difference " << d << "\n";
  return d;
}

/// Mean of the displacements of a symmetric arch and of their mirror image, as seen from the middle of its springings.
Solution symmetric_part(const Solution& s) {
  auto mean = s;
  const BlockId last = s.block_of_node.back();
  const double middle = 0.005 / 2;  // [m] half the settlement
  for (std::size_t i = 0; i < s.position.size(); ++i)
    for (std::size_t j = 0; j < s.position.size(); ++j) {
      const auto& x = s.position[i];
      const auto& y = s.position[j];
      // 1e-6 m: far above round-off, far below a cell.
      if (s.block_of_node[i] + s.block_of_node[j] != last || std::hypot(x[0] + y[0], x[1] - y[1]) > 1e-6) continue;
      const auto& u = s.displacement[i];
      const auto& v = s.displacement[j];
      mean.displacement[i] = {(u[0] - v[0]) / 2 + middle, (u[1] + v[1]) / 2};
    }
  return mean;
}

// Both runs close the contact conditions to 1e-8 of the forces; 1e-6 of the displacement leaves room for a structure
// that answers 100 times as much to what is left.
TEUCHOS_UNIT_TEST(Selection, ToleranceZeroGivesTheSolutionOfAllPointsOnAWallOf4) {
  TEST_COMPARE(difference_at_zero_tolerance(wall_scene(4), out), <, 1e-6);
}

TEUCHOS_UNIT_TEST(Selection, ToleranceZeroGivesTheSolutionOfAllPointsOnAWallOf8) {
  TEST_COMPARE(difference_at_zero_tolerance(wall_scene(8), out), <, 1e-6);
}

TEUCHOS_UNIT_TEST(Selection, ToleranceZeroGivesTheSolutionOfAllPointsOnAnArch) {
  TEST_COMPARE(difference_at_zero_tolerance(arch_scene(14), out), <, 1e-6);
}

// With an odd number of voussoirs the keystone is free to turn with one half of the arch or the other: two hinges on
// the same side of it leave a motion that costs nothing, and every solution along it is right. It is antisymmetric,
// so the mean of a solution and its mirror image is unique; so is the energy.
TEUCHOS_UNIT_TEST(Selection, ToleranceZeroGivesASolutionOfAllPointsOnAnArchWithAFreeKeystone) {
  Scene scene = arch_scene(15);
  const auto all = solved(scene);
  scene.selection.mode = SelectionMode::adaptive;
  scene.selection.error_tolerance = 0;
  const auto adaptive = solved(scene);
  const auto mean_all = symmetric_part(all), mean_adaptive = symmetric_part(adaptive);
  out << "difference " << difference(adaptive, all) << ", of symmetric parts " << difference(mean_adaptive, mean_all)
      << "\n";
  TEST_COMPARE(difference(mean_adaptive, mean_all), <, 1e-6);
  TEST_FLOATING_EQUALITY(adaptive.potential, all.potential, 1e-8);
}

TEUCHOS_UNIT_TEST(Selection, InfiniteStrengthIsTheBondedContinuum) {
  for (Scene scene : {wall_scene(4), arch_scene(15)}) {
    auto& law = scene.joints[0].parameters;
    law.friction_coefficient = law.cohesion = law.tension_strength = INFINITY;
    scene.newton.tolerance = 1e-11;
    const auto all = solved(scene);
    TEST_EQUALITY(all.selected(), static_cast<long long>(all.points.size()));
    scene.selection.mode = SelectionMode::bonded;
    const auto bonded = solved(scene);
    TEST_EQUALITY(bonded.selected(), 0);
    const double d = difference(all, bonded);
    out << scene.loads.back().name << ": " << d << "\n";
    TEST_COMPARE(d, <, 1e-8);
    // The same scene with its own strength is another one, or this test could not fail.
    scene.selection.mode = SelectionMode::all;
    law = {};
    scene.newton.tolerance = 1e-8;
    TEST_COMPARE(difference(solved(scene), bonded), >, 1e-3);
  }
}

// Without friction contact is the minimisation of a convex energy over the displacements that do not penetrate; a
// tied point only takes displacements away. The wall stands between two others, or it would slide off.
TEUCHOS_UNIT_TEST(Selection, WithoutFrictionMoreSelectedPointsNeverRaiseTheEnergy) {
  Scene scene = wall_scene(6);
  scene.joints[0].parameters.friction_coefficient = 0;
  add_support(scene, "left", "x");
  add_support(scene, "right", "x");
  apply_all_loads(scene);
  scene.selection.mode = SelectionMode::bonded;  // what is selected stays as it is
  Experiment experiment(scene);
  const auto start = experiment.state();
  double before = INFINITY, first = 0;
  for (int every : {0, 8, 4, 2, 1}) {  // each selection holds the one before
    experiment.state() = start;
    for (int k = 0; k < experiment.model().points().size(); ++k)
      experiment.state().selected[k] = every > 0 && experiment.model().points().points()[k].id % every == 0;
    TEST_ASSERT(experiment.run());
    const auto s = experiment.solution();
    out << s.selected() << " points selected: " << s.potential << " J\n";
    // Equilibrium to 1e-8 of the forces leaves an error of second order, 1e-16 and round-off, in the energy.
    TEST_COMPARE(s.potential, <=, before + 1e-12 * std::abs(s.potential));
    if (every == 0) first = s.potential;
    before = s.potential;
  }
  TEST_COMPARE(before, <, first - 1e-3 * std::abs(first));
}

}  // namespace
