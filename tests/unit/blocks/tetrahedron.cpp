// The tetrahedron against elasticity in closed form: rigid motions, uniform strain, integrals of its shape functions.
#include "blocks/tetrahedron.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <numeric>

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

}  // namespace
