// Hexahedra, plain and with modes of their own, against elasticity in closed form: rigid motions, uniform strain, mass.
#include "blocks/hexahedron.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <numeric>

#include "blocks/assembly.hpp"
#include "unit/blocks/cubes.hpp"
#include "unit/blocks/rigid_motions.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr auto kinds = {Hexahedra::plain, Hexahedra::incompatible};
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

TEUCHOS_UNIT_TEST(Hexahedron, IsSymmetricWithSixRigidMotionsAndNoOtherFreeMotion) {
  const auto block = distorted_cube();
  for (const auto kind : kinds)
    for (const auto& cell : block.cells) {
      const auto k = hexahedron_stiffness(cell_positions(block, cell), stone, kind);
      test::check_six_rigid_motions({k.begin(), k.end()}, 24, out, success);
    }
}

TEUCHOS_UNIT_TEST(BlockStiffness, OfHexahedraPassesThePatchTestOnADistortedMesh) {
  const auto block = distorted_cube();
  for (const auto kind : kinds) {
    const auto k = block_stiffness(block, stone, kind);
    std::vector<double> u, force(k.rows());
    for (const auto& x : block.position)
      for (double c : uniform_strain(x)) u.push_back(c);
    k.multiply(u.data(), force.data());
    // Under uniform strain nothing pulls at the inner node. Forces of about 1.
    for (int c = 0; c < 3; ++c) TEST_COMPARE(std::abs(force[3 * 13 + c]), <=, 1e-13);
    // The volume is 1: what bulges at two faces lies in their planes.
    TEST_FLOATING_EQUALITY(std::inner_product(u.begin(), u.end(), force.begin(), 0.0) / 2, energy_density(), 1e-13);
  }
}

TEUCHOS_UNIT_TEST(BlockStiffness, OfHexahedraLetsABlockMoveAndTurn) {
  const auto block = distorted_cube();
  for (const auto kind : kinds) {
    const auto k = block_stiffness(block, stone, kind);
    const Vector<3> turn{1, -2, 0.5};
    std::vector<double> u, force(k.rows());
    for (const auto& x : block.position)
      for (double c : Vector<3>{3, 1, -1} + cross(turn, x)) u.push_back(c);
    k.multiply(u.data(), force.data());
    for (double f : force) TEST_COMPARE(std::abs(f), <=, 1e-13);  // entries of the size of E, 81 terms each
  }
}

/// Bending about x: what lies above the middle is stretched along y, and nothing is sheared where fibres may bow.
TEUCHOS_UNIT_TEST(Hexahedron, BendsWithoutShearingWhereItHasModesOfItsOwn) {
  const auto block = cube(0, 1);
  const auto& cell = block.cells[0];
  std::vector<double> u;
  for (const auto& x : block.position)
    for (double c : Vector<3>{0, (x[2] - 0.5) * (x[1] - 0.5), 0}) u.push_back(c);
  const auto energy = [&](Hexahedra kind, double poisson_ratio) {
    const auto k = hexahedron_stiffness(cell_positions(block, cell), {1, poisson_ratio, 1}, kind);
    double sum = 0;
    for (int a = 0; a < 24; ++a)
      for (int b = 0; b < 24; ++b) {
        const int row = 3 * cell.node[a / 3] + a % 3, column = 3 * cell.node[b / 3] + b % 3;
        sum += u[row] * k[24 * a + b] * u[column] / 2;
      }
    return sum;
  };
  // Of a beam E I / 2 = 1/24, the curvature being one; G = E / 2 adds the shear y of plain cells, 1/48.
  TEST_FLOATING_EQUALITY(energy(Hexahedra::incompatible, 0), 1.0 / 24, 1e-14);
  TEST_FLOATING_EQUALITY(energy(Hexahedra::plain, 0), 1.0 / 24 + 1.0 / 48, 1e-14);
  // Fibres that bow across the beam as well have the energy of a plate: E / (1 - nu^2).
  TEST_FLOATING_EQUALITY(energy(Hexahedra::incompatible, 0.3), 1.0 / 24 / (1 - 0.09), 1e-13);
}

TEUCHOS_UNIT_TEST(Hexahedron, HasTheMeanStressOfUniformStrainAndNoneOfAMotion) {
  const auto block = distorted_cube();
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  for (const auto& cell : block.cells) {
    const auto x = cell_positions(block, cell);
    std::array<Vector<3>, 8> strained, moved;
    for (int i = 0; i < 8; ++i) {
      strained[i] = uniform_strain(x[i]);
      moved[i] = Vector<3>{1, 2, 3} + cross(Vector<3>{1, -2, 0.5}, x[i]);
    }
    const auto found = hexahedron_stress(x, strained, stone), none = hexahedron_stress(x, moved, stone);
    const std::array<double, 6> expected{2 * lambda + 6 * mu, 3 * mu, -2 * mu,  // xx, xy, xz
                                         2 * lambda - 4 * mu, mu,     2 * lambda + 2 * mu};
    for (int c = 0; c < 6; ++c) {
      TEST_COMPARE(std::abs(found[c] - expected[c]), <=, 1e-13);
      TEST_COMPARE(std::abs(none[c]), <=, 1e-13);
    }
  }
}

// Velocities that are linear in space are those of the shape functions: the cube's moment about an axis through its
// middle is m / 6, turned or not.
TEUCHOS_UNIT_TEST(BlockMass, OfHexahedraHasTheEnergyOfABodyThatFliesAndSpins) {
  const double density = 2.5;
  auto block = cube(0, 2);
  for (auto& x : block.position) x = turned(x);
  const auto energy = [&](Mass kind, const Vector<3>& velocity, const Vector<3>& spin) {
    const auto m = block_mass(block, density, kind);
    std::vector<double> v, mv(m.rows());
    for (const auto& x : block.position)
      for (const double c : velocity + cross(spin, x - turned({0.5, 0.5, 0.5}))) v.push_back(c);
    m.multiply(v.data(), mv.data());
    return std::inner_product(v.begin(), v.end(), mv.begin(), 0.0) / 2;
  };
  for (const auto kind : {Mass::consistent, Mass::lumped})
    TEST_FLOATING_EQUALITY(energy(kind, {3, -4, 12}, {0, 0, 0}), density * 169 / 2, 1e-13);
  TEST_FLOATING_EQUALITY(energy(Mass::consistent, {0, 0, 0}, {2, -1, 2}), density * 9 / 12, 1e-13);
  TEST_COMPARE(energy(Mass::lumped, {0, 0, 0}, {2, -1, 2}), >, 1.05 * density * 9 / 12);
}

}  // namespace
