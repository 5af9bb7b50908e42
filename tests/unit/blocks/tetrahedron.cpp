// The tetrahedron against elasticity in closed form: rigid motions, uniform strain, integrals of its shape functions.
#include "blocks/tetrahedron.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <numeric>

#include "blocks/assembly.hpp"
#include "unit/blocks/rigid_motions.hpp"

namespace {

using namespace voussoir;

const Material stone{2.5, 0.3, 1.0};  // numbers near 1, so that absolute tolerances mean relative ones
const std::array<Vector<3>, 4> corners{{{0.1, 0, 0.2}, {1.3, 0.2, 0}, {0.3, 0.9, -0.1}, {0.2, 0.4, 1.1}}};

double volume() { return dot(corners[3] - corners[0], cross(corners[1] - corners[0], corners[2] - corners[0])) / 6; }

/// Strain (xx, yy, zz, yz, zx, xy) = (3, -2, 1, 1, -2, 3) with engineering shear, and a rotation.
Vector<3> uniform_strain(const Vector<3>& x) {
  return {0.5 + 3 * x[0] + x[1] - x[2], -1 + 2 * x[0] - 2 * x[1] + 0.5 * x[2], 2 - x[0] + 0.5 * x[1] + x[2]};
}

TEUCHOS_UNIT_TEST(Tetrahedron, HasSixRigidMotionsAndNoOtherFreeMotion) {
  const auto k = tetrahedron_stiffness(corners, stone);
  test::check_six_rigid_motions({k.begin(), k.end()}, 12, out, success);
}

TEUCHOS_UNIT_TEST(Tetrahedron, HoldsTheEnergyAndTheStressOfUniformStrain) {
  std::array<Vector<3>, 4> u;
  for (int i = 0; i < 4; ++i) u[i] = uniform_strain(corners[i]);
  const auto k = tetrahedron_stiffness(corners, stone);
  double energy = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) energy += u[i / 3][i % 3] * k[12 * i + j] * u[j / 3][j % 3] / 2;
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  TEST_FLOATING_EQUALITY(energy, volume() * (lambda * 2 * 2 / 2 + mu * (9 + 4 + 1 + (1 + 4 + 9) / 2.0)), 1e-13);
  const std::array<double, 6> exact{2 * lambda + 6 * mu, 3 * mu, -2 * mu, 2 * lambda - 4 * mu, mu, 2 * lambda + 2 * mu};
  const auto stress = tetrahedron_stress(corners, u, stone);
  for (int i = 0; i < 6; ++i) TEST_COMPARE(std::abs(stress[i] - exact[i]), <=, 1e-13);
}

TEUCHOS_UNIT_TEST(Tetrahedron, SharesItsVolumeAndMassAmongItsNodes) {
  const auto share = tetrahedron_volumes(corners);
  TEST_FLOATING_EQUALITY(std::accumulate(share.begin(), share.end(), 0.0), volume(), 1e-14);
  const auto product = tetrahedron_products(corners);
  TEST_FLOATING_EQUALITY(std::accumulate(product.begin(), product.end(), 0.0), volume(), 1e-14);
  for (int i = 0; i < 4; ++i)  // shape functions sum to 1
    TEST_FLOATING_EQUALITY(std::accumulate(product.begin() + 4 * i, product.begin() + 4 * i + 4, 0.0), share[i], 1e-14);
}

/// A cube of side 1, a hexahedron, under one of six tetrahedra.
Block<3> cube_under_six_tetrahedra() {
  Block<3> block;
  for (int k = 0; k < 3; ++k)
    for (const auto& at : std::array<Vector<2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}})
      block.position.push_back({at[0], at[1], double(k)});
  block.cells.push_back({{0, 1, 2, 3, 4, 5, 6, 7}, 8});
  for (const auto& [a, b] : std::array<std::array<int, 2>, 6>{{{5, 6}, {6, 7}, {7, 11}, {11, 8}, {8, 9}, {9, 5}}})
    block.cells.push_back({{4, a, b, 10}, 4});
  return block;
}

TEUCHOS_UNIT_TEST(Tetrahedron, SharesABlockWithHexahedra) {
  const auto block = cube_under_six_tetrahedra();
  const auto volume = nodal_volumes(block);
  TEST_FLOATING_EQUALITY(std::accumulate(volume.begin(), volume.end(), 0.0), 2.0, 1e-14);
  TEST_FLOATING_EQUALITY(volume[0], 1 / 8.0, 1e-14);
  TEST_FLOATING_EQUALITY(volume[4], 1 / 8.0 + 1 / 4.0, 1e-14);  // a corner of all six
  TEST_FLOATING_EQUALITY(volume[8], 2 / 24.0, 1e-14);
  const auto size = cell_sizes(block);
  TEST_FLOATING_EQUALITY(size[0], 1.0, 1e-14);
  TEST_FLOATING_EQUALITY(size[8], std::cbrt(1 / 6.0), 1e-14);
  for (const auto kind : {Mass::consistent, Mass::lumped}) {
    const auto mass = block_mass(block, 3.0, kind);
    TEST_FLOATING_EQUALITY(std::accumulate(mass.value.begin(), mass.value.end(), 0.0), 3 * 2 * 3.0, 1e-14);
  }
  // Uniform strain costs as much in all cells.
  const auto k = block_stiffness(block, stone, Hexahedra{});
  std::vector<double> u, force(36);
  for (const auto& x : block.position)
    for (const double c : uniform_strain(x)) u.push_back(c);
  k.multiply(u.data(), force.data());
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  const double density = lambda * 2 * 2 / 2 + mu * (9 + 4 + 1 + (1 + 4 + 9) / 2.0);
  TEST_FLOATING_EQUALITY(std::inner_product(u.begin(), u.end(), force.begin(), 0.0) / 2, 2 * density, 1e-13);
}

}  // namespace
