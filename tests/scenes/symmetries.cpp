// What units, reflections and rotations must not change.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// The same scene in units of length, force and second: mm, N, s are (1e3, 1).
Scene in_units(Scene scene, double lengths_per_metre, double forces_per_newton) {
  auto& wall = scene.mesh.wall;
  auto& arch = scene.mesh.arch;
  for (double* length : {&wall.block_length, &wall.block_height, &arch.radius, &arch.thickness, &scene.model.thickness})
    *length *= lengths_per_metre;
  auto& stone = scene.materials[0].parameters;
  stone.young_modulus *= forces_per_newton / std::pow(lengths_per_metre, 2);
  stone.density *= forces_per_newton / std::pow(lengths_per_metre, 4);
  for (auto& load : scene.loads) {
    if (auto* weight = load_as<SelfWeightParameters>(load)) weight->gravity *= lengths_per_metre;
    if (auto* push = load_as<AccelerationParameters>(load)) push->ax *= lengths_per_metre;
    if (auto* move = load_as<SettlementParameters>(load)) move->ux *= lengths_per_metre;
  }
  return scene;
}

std::vector<Scene> scenes_in_both_modes() {
  std::vector<Scene> scenes = {wall_scene(8), wall_scene(8), arch_scene(14), arch_scene(14)};
  scenes[1].selection.mode = scenes[3].selection.mode = SelectionMode::adaptive;
  return scenes;
}

// Powers of two change exponents only, so a program without a hidden unit does the very same arithmetic.
TEUCHOS_UNIT_TEST(Symmetries, UnitsThatArePowersOfTwoChangeNotASingleBit) {
  for (const auto& scene : scenes_in_both_modes()) {
    const auto si = solved(scene);
    const auto other = solved(in_units(scene, 1024, 64));
    TEST_EQUALITY(other.sum.newton_iterations, si.sum.newton_iterations);
    TEST_EQUALITY(other.sum.outer_iterations, si.sum.outer_iterations);
    TEST_EQUALITY(other.sum.krylov_iterations, si.sum.krylov_iterations);
    TEST_EQUALITY(other.rounds, si.rounds);
    TEST_EQUALITY(other.selected(), si.selected());
    int equal = 0;
    for (std::size_t i = 0; i < si.displacement.size(); ++i)
      equal += other.displacement[i] == 1024.0 * si.displacement[i];
    TEST_EQUALITY(equal, static_cast<int>(si.displacement.size()));
  }
}

TEUCHOS_UNIT_TEST(Symmetries, MillimetresNewtonsAndTonnesGiveTheSameResult) {
  for (const auto& scene : scenes_in_both_modes()) {
    const auto si = solved(scene);
    auto other = solved(in_units(scene, 1000, 1));
    for (auto& u : other.displacement) u = 1e-3 * u;
    const double d = difference(other, si);
    out << si.sum.newton_iterations << " and " << other.sum.newton_iterations << " linear solves, difference " << d
        << "\n";
    TEST_COMPARE(d, <, 1e-6);
    TEST_EQUALITY(other.selected(), si.selected());
    // Round-off decides the status of points on the edge of theirs, which can cost a solve here and there.
    TEST_COMPARE(std::abs(other.sum.newton_iterations - si.sum.newton_iterations), <=,
                 1 + 0.05 * si.sum.newton_iterations);
  }
}

// The left springing moves outward instead of the right one. 14 voussoirs: see selection.cpp for odd numbers.
TEUCHOS_UNIT_TEST(Symmetries, AReflectedArchMovesReflected) {
  Scene scene = arch_scene(14);
  load_as<SettlementParameters>(scene.loads[1])->ux = 0.003;
  load_as<SettlementParameters>(scene.loads[1])->uy = -0.002;  // breaks the symmetry between the springings
  const auto right = solved(scene);
  load_as<SettlementParameters>(scene.loads[1])->support = "springing left";
  load_as<SettlementParameters>(scene.loads[1])->ux *= -1;
  const auto left = solved(scene);
  auto reflected = right;
  int found = 0;
  for (std::size_t i = 0; i < left.position.size(); ++i)
    for (std::size_t j = 0; j < left.position.size(); ++j) {
      const auto& x = left.position[i];
      const auto& y = left.position[j];
      // 1e-6 m: far above round-off, far below a cell.
      const bool pair =
          left.block_of_node[i] + left.block_of_node[j] == 13 && std::hypot(x[0] + y[0], x[1] - y[1]) < 1e-6;
      if (!pair) continue;
      ++found;
      reflected.displacement[i] = {-right.displacement[j][0], right.displacement[j][1]};
    }
  TEST_EQUALITY(found, static_cast<int>(left.position.size()));
  out << "difference " << difference(left, reflected) << "\n";
  TEST_COMPARE(difference(left, reflected), <, 1e-6);
  TEST_COMPARE(difference(left, right), >, 0.1);
}

/// Three stones and their loads, turned by an angle [degree].
Solution turned(double angle, CellType cells) {
  Scene scene = gmsh_scene(repository("/tests/scenes/geo/three_stones.geo"), 0.25, cells);
  scene.mesh.gmsh.geometry = {{"angle", angle}, {"structured", 1}};
  add_support(scene, "bottom", "xy");
  const double a = angle * M_PI / 180, ax = 0.2 * 9.81, ay = -9.81;  // enough to open the upright joint
  add_gravity(scene, std::cos(a) * ax - std::sin(a) * ay, std::sin(a) * ax + std::cos(a) * ay);
  apply_all_loads(scene);
  return solved(scene);
}

TEUCHOS_UNIT_TEST(Symmetries, ARotatedStructureMovesRotated) {
  for (const auto cells : {CellType::triangle, CellType::quadrilateral}) {
    const double angle = 37, a = angle * M_PI / 180;
    const auto upright = turned(0, cells);
    const auto leaning = turned(angle, cells);
    auto expected = upright;
    TEST_EQUALITY(leaning.position.size(), upright.position.size());
    double apart = 0;
    for (std::size_t i = 0; i < upright.position.size(); ++i) {
      const auto turn = [&](const Vector<2>& v) {
        return Vector<2>{std::cos(a) * v[0] - std::sin(a) * v[1], std::sin(a) * v[0] + std::cos(a) * v[1]};
      };
      apart = std::max(apart, norm(turn(upright.position[i]) - leaning.position[i]));
      expected.displacement[i] = turn(upright.displacement[i]);
    }
    TEST_COMPARE(apart, <, 1e-9);  // [m] gmsh writes nodes with 16 digits
    out << "difference " << difference(leaning, expected) << "\n";
    TEST_COMPARE(difference(leaning, expected), <, 1e-6);
    TEST_ASSERT(std::any_of(upright.points.begin(), upright.points.end(), [](const auto& p) { return p.gap > 1e-9; }));
  }
}

}  // namespace
