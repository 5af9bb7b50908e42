// The error estimate of what stays tied, beside the error itself: the difference to the solution of all points.
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

double elastic_energy(const Structure<2>& structure, const std::vector<double>& u) {
  std::vector<double> ku;
  structure.apply_stiffness(u, ku);
  double mine = 0, all = 0;
  for (int i = 0; i < 2 * structure.owned_nodes(); ++i) mine += u[i] * ku[i] / 2;
  Teuchos::reduceAll(*structure.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

/// Solves a scene in one load step, so that no history of slips differs, with all points and with those that some
/// tolerances ask for.
void hold_estimate_to_the_error(Scene scene, const std::vector<double>& tolerances, Teuchos::FancyOStream& out,
                                bool& success) {
  apply_all_loads(scene);
  Experiment all(scene);
  TEST_ASSERT(all.run());
  const auto& u = all.state().displacement;
  const double energy = elastic_energy(all.model().structure(), u);

  scene.selection.mode = SelectionMode::adaptive;
  scene.selection.largest_share = 1;
  scene.selection.bulk = 0.5;  // small rounds, for more selections between none and enough
  long long before = -1;
  for (const double tolerance : tolerances) {
    scene.selection.error_tolerance = tolerance;
    Experiment some(scene);
    TEST_ASSERT(some.run());
    const auto s = some.solution();
    TEST_COMPARE(s.selected(), >, before);  // or this compares the same thing twice
    before = s.selected();
    auto e = some.state().displacement;
    for (std::size_t i = 0; i < e.size(); ++i) e[i] -= u[i];
    const double error = std::sqrt(elastic_energy(some.model().structure(), e) / energy);
    const double estimate = s.last.error_estimate;
    out << s.selected() << " of " << s.points.size() << " points selected: error " << error << ", estimate " << estimate
        << ", ratio " << estimate / error << "\n";
    TEST_COMPARE(estimate, <=, tolerance);
    // What users are promised of an estimate: between half the error and five times it.
    TEST_COMPARE(estimate, >=, 0.5 * error);
    TEST_COMPARE(estimate, <=, 5 * error);
  }
}

TEUCHOS_UNIT_TEST(ErrorEstimate, IsNearTheErrorOnAWallOf8) {
  hold_estimate_to_the_error(wall_scene(8), {0.99, 0.05, 0.02, 0.005}, out, success);
}

TEUCHOS_UNIT_TEST(ErrorEstimate, IsNearTheErrorOnAWallOf16) {
  hold_estimate_to_the_error(wall_scene(16), {0.99, 0.05, 0.02}, out, success);
}

TEUCHOS_UNIT_TEST(ErrorEstimate, IsNearTheErrorOnAnArch) {
  hold_estimate_to_the_error(arch_scene(31), {0.3, 0.1, 0.01}, out, success);
}

// On an arch whose springing has moved nearly all the stress of the bonded continuum is error.
TEUCHOS_UNIT_TEST(ErrorEstimate, IsNearTheErrorOfABondedArch) {
  Scene scene = arch_scene(31);
  apply_all_loads(scene);
  Experiment all(scene);
  TEST_ASSERT(all.run());
  scene.selection.mode = SelectionMode::bonded;
  Experiment bonded(scene);
  TEST_ASSERT(bonded.run());
  const auto& structure = all.model().structure();
  auto e = bonded.state().displacement;
  for (std::size_t i = 0; i < e.size(); ++i) e[i] -= all.state().displacement[i];
  const double error = std::sqrt(elastic_energy(structure, e) / elastic_energy(structure, all.state().displacement));
  const double estimate = bonded.solution().last.error_estimate;
  out << "error " << error << ", estimate " << estimate << "\n";
  TEST_COMPARE(error, >, 1);
  TEST_COMPARE(estimate, >=, 0.5 * error);
  TEST_COMPARE(estimate, <=, 5 * error);
}

TEUCHOS_UNIT_TEST(ErrorEstimate, IsZeroAndCostsNothingWhereNoTieIsViolated) {
  Scene scene = wall_scene(4);
  scene.joints[0].parameters.friction_coefficient = INFINITY;
  scene.joints[0].parameters.cohesion = scene.joints[0].parameters.tension_strength = INFINITY;
  scene.selection.mode = SelectionMode::adaptive;
  const auto s = solved(scene);
  TEST_EQUALITY(s.selected(), 0);
  TEST_EQUALITY(s.last.error_estimate, 0);
  TEST_EQUALITY(s.last.estimate_solves, 0);
}

}  // namespace
