// Patch test: under uniform pressure joints that stick carry the same traction everywhere, whatever the mesh.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <map>

#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double pressure = 1e6;  // [Pa]

/// Number of blocks at the place of a point: where three meet, forces of single points are not unique.
std::map<std::pair<long long, long long>, int> blocks_at(const Solution& s) {
  std::map<std::pair<long long, long long>, int> count;
  for (const auto& x : s.position) ++count[{std::llround(x[0] * 1e6), std::llround(x[1] * 1e6)}];
  return count;
}

struct PatchErrors {
  double traction = 0;      ///< relative to the pressure on top
  double displacement = 0;  ///< relative to the largest
  int points = 0;
};

/// Against the uniform stress (-sx, -sy) of a rectangle with its lower left corner at the origin.
PatchErrors patch_errors(const Solution& s, double sx, double sy, double young_modulus, double poisson_ratio) {
  PatchErrors e;
  const auto count = blocks_at(s);
  const double ex = (-sx + poisson_ratio * sy) / young_modulus, ey = (-sy + poisson_ratio * sx) / young_modulus;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    const Vector<2> u{ex * s.position[i][0], ey * s.position[i][1]};
    e.displacement = std::max(e.displacement, norm(s.displacement[i] - u) / s.largest_displacement());
  }
  for (const auto& p : s.points) {
    if (s.held[p.node_i][0] || s.held[p.node_i][1]) continue;  // the support takes what it likes
    if (count.at({std::llround(p.position[0] * 1e6), std::llround(p.position[1] * 1e6)}) > 2) continue;
    const auto& n = p.normal;
    const double normal = sx * n[0] * n[0] + sy * n[1] * n[1];  // compression
    const double tangential = (sx - sy) * n[0] * n[1] * -1.0;   // along (-n_y, n_x)
    e.traction = std::max({e.traction, std::abs(p.normal_force / p.area - normal) / pressure,
                           std::abs(p.tangential_force / p.area - tangential) / pressure});
    ++e.points;
  }
  return e;
}

void report(const PatchErrors& e, Teuchos::FancyOStream& out) {
  out << e.points << " points, traction " << e.traction << ", displacement " << e.displacement << "\n";
}

// Without Poisson's effect a wall on a fixed base is in uniform compression; its upright joints carry nothing.
TEUCHOS_UNIT_TEST(Patch, AWallUnderPressureCarriesItUniformly) {
  for (const auto cells : {CellType::triangle, CellType::quadrilateral}) {
    Scene scene = wall_scene(4);
    scene.mesh.wall.cells = cells;
    scene.materials[0].parameters.poisson_ratio = 0;
    scene.newton.tolerance = 1e-13;
    scene.loads.clear();
    add_pressure(scene, "top", pressure);
    apply_all_loads(scene);
    const auto s = solved(scene);
    const auto e = patch_errors(s, 0, pressure, 10e9, 0);
    report(e, out);
    TEST_COMPARE(e.points, >, 40);
    TEST_COMPARE(e.traction, <, 1e-12);
    TEST_COMPARE(e.displacement, <, 1e-12);
  }
}

// The same from another state: first under its own weight, then under pressure alone. The contact forces have to be
// found, not only confirmed; Newton stops at 1e-13 of the largest force.
TEUCHOS_UNIT_TEST(Patch, AWallWhoseWeightGivesWayToPressureCarriesItUniformly) {
  Scene scene = wall_scene(4);
  scene.materials[0].parameters.poisson_ratio = 0;
  scene.newton.tolerance = 1e-13;
  add_pressure(scene, "top", pressure);
  Experiment experiment(scene);
  TEST_ASSERT(experiment.advance({{"weight", 1}}));
  TEST_ASSERT(experiment.advance({{"pressure on top", 1}}));
  const auto e = patch_errors(experiment.solution(), 0, pressure, 10e9, 0);
  report(e, out);
  TEST_COMPARE(experiment.solution().last.newton.newton_iterations, >, 1);
  TEST_COMPARE(e.traction, <, 1e-11);
  TEST_COMPARE(e.displacement, <, 1e-11);
}

// Half the pressure from the side: shear on every leaning joint, but less than friction can carry.
TEUCHOS_UNIT_TEST(Patch, IrregularStonesUnderPressureFromTwoSidesCarryItUniformly) {
  for (const auto cells : {CellType::triangle, CellType::quadrilateral}) {
    for (const auto mode : {SelectionMode::all, SelectionMode::bonded}) {
      Scene scene = gmsh_scene(repository("/tests/scenes/geo/three_stones.geo"), 0.2, cells);
      scene.selection.mode = mode;
      scene.newton.tolerance = 1e-13;
      add_support(scene, "bottom", "y");
      add_support(scene, "left", "x");
      add_pressure(scene, "top", pressure);
      add_pressure(scene, "right", pressure / 2);
      apply_all_loads(scene);
      const auto s = solved(scene);
      const auto e = patch_errors(s, pressure / 2, pressure, 10e9, 0.2);
      report(e, out);
      TEST_COMPARE(e.points, >, 5);
      TEST_COMPARE(e.traction, <, 1e-12);
      TEST_COMPARE(e.displacement, <, 1e-12);
    }
  }
}

}  // namespace
