// The hexahedron against elasticity in closed form: rigid motions, uniform strain.
#include "blocks/hexahedron.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <numeric>

#include "blocks/assembly.hpp"
#include "unit/blocks/cubes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

const Material stone{2.5, 0.3, 1.0};  // numbers near 1, so that absolute tolerances mean relative ones

/// Strain (xx, yy, zz, yz, zx, xy) = (3, -2, 1, 1, -2, 3) with engineering shear, and a rotation.
Vector<3> uniform_strain(const Vector<3>& x) {
  return {0.5 + 3 * x[0] + x[1] - x[2], -1 + 2 * x[0] - 2 * x[1] + 0.5 * x[2], 2 - x[0] + 0.5 * x[1] + x[2]};
}

/// Half of stress times strain, by Lame's numbers: lambda (tr e)^2 / 2 + mu e : e.
double energy_density() {
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  return lambda * 2 * 2 / 2 + mu * (9 + 4 + 1 + (1 + 4 + 9) / 2.0);
}

/// A turned cube of 2 x 2 x 2 cells whose middle node is moved, and those in the middles of two faces.
Block<3> distorted_cube() {
  auto block = cube(0, 2);
  block.position[13] = {0.6, 0.45, 0.58};
  block.position[4] = {0.4, 0.55, 0};
  block.position[14] = {1, 0.42, 0.55};
  for (auto& x : block.position) x = turned(x);
  return block;
}

std::array<Vector<3>, 8> corners(const Block<3>& block, const Cell& cell) {
  std::array<Vector<3>, 8> x;
  for (int i = 0; i < 8; ++i) x[i] = block.position[cell.node[i]];
  return x;
}

TEUCHOS_UNIT_TEST(Hexahedron, IsSymmetricWithSixRigidMotionsAndNoOtherFreeMotion) {
  const auto block = distorted_cube();
  for (const auto& cell : block.cells) {
    auto k = hexahedron_stiffness(corners(block, cell), stone);
    constexpr int n = 24;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j) TEST_COMPARE(std::abs(k[i * n + j] - k[j * n + i]), <=, 1e-15 * 10);
    std::vector<double> eigenvalue(n), work(10 * n);
    int info = 0;
    Teuchos::LAPACK<int, double>().SYEV('N', 'U', n, k.data(), n, eigenvalue.data(), work.data(), 10 * n, &info);
    TEST_EQUALITY(info, 0);
    for (int i = 0; i < 6; ++i) TEST_COMPARE(std::abs(eigenvalue[i]), <=, 1e-14);
    // Fewer quadrature points would leave hourglass motions of zero energy.
    TEST_COMPARE(eigenvalue[6], >=, 0.01 * eigenvalue[n - 1]);
  }
}

TEUCHOS_UNIT_TEST(BlockStiffness, OfHexahedraPassesThePatchTestOnADistortedMesh) {
  const auto block = distorted_cube();
  const auto k = block_stiffness(block, stone);
  std::vector<double> u, force(k.rows());
  for (const auto& x : block.position)
    for (double c : uniform_strain(x)) u.push_back(c);
  k.multiply(u.data(), force.data());
  // Under uniform strain nothing pulls at the inner node. Forces of about 1.
  for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(force[3 * 13 + c]), <=, 1e-13);
  // The volume is 1: what bulges at two faces lies in their planes.
  TEST_FLOATING_EQUALITY(std::inner_product(u.begin(), u.end(), force.begin(), 0.0) / 2, energy_density(), 1e-13);
}

TEUCHOS_UNIT_TEST(BlockStiffness, OfHexahedraLetsABlockMoveAndTurn) {
  const auto block = distorted_cube();
  const auto k = block_stiffness(block, stone);
  const Vector<3> turn{1, -2, 0.5};
  std::vector<double> u, force(k.rows());
  for (const auto& x : block.position)
    for (double c : Vector<3>{3, 1, -1} + cross(turn, x)) u.push_back(c);
  k.multiply(u.data(), force.data());
  for (double f : force) TEST_COMPARE(std::abs(f), <=, 1e-13);  // entries of the size of E, 81 terms each
}

}  // namespace
