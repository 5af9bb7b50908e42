// Convergence of the bonded continuum to a ring under inner pressure (G. Lame, Lecons sur la theorie mathematique de
// l'elasticite des corps solides, 1852): displacement O(h^2), energy norm O(h), for triangles and quadrilaterals.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "blocks/assembly.hpp"
#include "blocks/element_matrices.hpp"
#include "support/repository.hpp"
#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double inner = 1, outer = 2, pressure = 1e6;       // [m, m, Pa]
constexpr double young_modulus = 10e9, poisson_ratio = 0.2;  // [Pa, -], plane stress

// Stresses a - b / r^2 radial, a + b / r^2 around.
const double a = pressure * inner * inner / (outer * outer - inner * inner), b = a * outer * outer;

/// u_r = c r + d / r
const double c = a * (1 - poisson_ratio) / young_modulus, d = b * (1 + poisson_ratio) / young_modulus;

Vector<2> exact_displacement(const Vector<2>& x) {
  const double r2 = dot(x, x);
  return (c + d / r2) * x;
}

/// xx, yy, xy (engineering shear).
std::array<double, 3> exact_strain(const Vector<2>& x) {
  const double r2 = dot(x, x), r4 = r2 * r2;
  return {c + d / r2 - 2 * d * x[0] * x[0] / r4, c + d / r2 - 2 * d * x[1] * x[1] / r4, -4 * d * x[0] * x[1] / r4};
}

struct Errors {
  double displacement = 0;  ///< relative, mean square of the nodes
  double energy = 0;        ///< relative, energy norm
};

/// Points inside a cell where strains are compared: Gauss points of quadrilaterals, three points of triangles, where
/// the strain is constant but the exact one is not.
std::vector<std::pair<ShapeValues, Vector<2>>> samples(const Cell& cell, const std::array<Vector<2>, 4>& x) {
  std::vector<std::pair<ShapeValues, Vector<2>>> points;
  for (auto s : shape_values(cell, x)) {
    if (cell.count == 4) {
      Vector<2> at{};
      for (int i = 0; i < 4; ++i) at = at + s.value[i] * x[i];
      points.push_back({s, at});
      continue;
    }
    s.weight /= 3;
    for (int i = 0; i < 3; ++i) points.push_back({s, 0.5 * (x[i] + x[(i + 1) % 3])});
  }
  return points;
}

double energy_density(const std::array<std::array<double, 3>, 3>& elasticity, const std::array<double, 3>& strain) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += strain[i] * elasticity[i][j] * strain[j] / 2;
  return sum;
}

Errors errors(double element_size, CellType cells) {
  Scene scene = gmsh_scene(repository("/tests/convergence/geo/quarter_ring.geo"), element_size, cells);
  scene.selection.mode = SelectionMode::bonded;
  add_support(scene, "on x axis", "y");
  add_support(scene, "on y axis", "x");
  add_pressure(scene, "inside", pressure);
  apply_all_loads(scene);
  Experiment experiment(scene);
  Errors e;
  if (!experiment.run()) return {1, 1};
  const auto& u = experiment.state().displacement;
  double apart = 0, size = 0;
  for (const auto& block : experiment.model().structure().blocks()) {
    const auto volume = nodal_volumes(block.mesh, 1.0);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      const auto exact = exact_displacement(block.mesh.position[i]);
      const std::size_t k = 2 * (static_cast<std::size_t>(block.first_local) + i);
      const auto difference = Vector<2>{u[k], u[k + 1]} - exact;
      apart += volume[i] * dot(difference, difference);
      size += volume[i] * dot(exact, exact);
    }
  }
  e.displacement = std::sqrt(apart / size);
  double wrong = 0, all = 0;
  for (const auto& block : experiment.model().structure().blocks())
    for (const auto& cell : block.mesh.cells)
      for (const auto& [shape, at] : samples(cell, cell_positions(block.mesh, cell))) {
        std::array<double, 3> strain{};
        for (int i = 0; i < cell.count; ++i) {
          const int k = 2 * (block.first_local + cell.node[i]);
          strain[0] += shape.gradient[i][0] * u[k];
          strain[1] += shape.gradient[i][1] * u[k + 1];
          strain[2] += shape.gradient[i][1] * u[k] + shape.gradient[i][0] * u[k + 1];
        }
        const auto elasticity = plane_elasticity(block.material, Plane::stress);
        const auto exact = exact_strain(at);
        all += shape.weight * energy_density(elasticity, exact);
        wrong += shape.weight *
                 energy_density(elasticity, {strain[0] - exact[0], strain[1] - exact[1], strain[2] - exact[2]});
      }
  e.energy = std::sqrt(wrong / all);
  return e;
}

void check_rates(CellType cells, Teuchos::FancyOStream& out, bool& success) {
  Errors coarse = errors(0.25, cells);
  for (double h : {0.125, 0.0625}) {
    const Errors fine = errors(h, cells);
    const double displacement = std::log2(coarse.displacement / fine.displacement),
                 energy = std::log2(coarse.energy / fine.energy);
    out << "h = " << h << " m: displacement " << fine.displacement << ", rate " << displacement << "; energy norm "
        << fine.energy << ", rate " << energy << "\n";
    // With 4 to 16 cells through the ring the limit is near, not reached: 5 and 10 percent of slack.
    TEST_COMPARE(displacement, >, 1.9);
    TEST_COMPARE(energy, >, 0.9);
    coarse = fine;
  }
}

TEUCHOS_UNIT_TEST(Elastic, TrianglesConvergeToTheRingUnderPressure) { check_rates(CellType::triangle, out, success); }

TEUCHOS_UNIT_TEST(Elastic, QuadrilateralsConvergeToTheRingUnderPressure) {
  check_rates(CellType::quadrilateral, out, success);
}

}  // namespace
