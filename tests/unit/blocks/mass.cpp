// Mass of a block against rigid bodies: weight, moment of inertia, no matter how it is meshed.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "unit/blocks/lattice_block.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double side = 3, density = 2.5, thickness = 0.7;
constexpr double whole = side * side * density * thickness;  // [kg]

/// A square of 3 x 3 cells whose inner nodes are moved; triangles halve the cells.
Block<2> square(bool triangles) {
  auto block = block_of_cells(0, rectangle(0, 0, 3, 3));
  for (auto& x : block.position) {
    const Vector<2> at = x;
    x[0] += 0.1 * at[0] * (3 - at[0]) * at[1] * (3 - at[1]) / 4;
    x[1] -= 0.15 * at[0] * (3 - at[0]) * at[1] * (3 - at[1]) / 4;
  }
  return triangles ? in_triangles(block) : block;
}

/// 1/2 v.M v
template <class Velocity>
double kinetic_energy(const Block<2>& block, Mass kind, const Velocity& at) {
  const auto m = block_mass(block, density, thickness, kind);
  std::vector<double> v, mv(m.rows());
  for (const auto& x : block.position)
    for (const double component : at(x)) v.push_back(component);
  m.multiply(v.data(), mv.data());
  double energy = 0;
  for (std::size_t i = 0; i < v.size(); ++i) energy += v[i] * mv[i] / 2;
  return energy;
}

TEUCHOS_UNIT_TEST(BlockMass, ATranslationHasTheEnergyOfTheWholeMassHoweverMeshed) {
  for (const bool triangles : {false, true})
    for (const auto kind : {Mass::consistent, Mass::lumped})  // some hundred terms of one size
      TEST_FLOATING_EQUALITY(kinetic_energy(square(triangles), kind,
                                            [](const Vector<2>&) {
                                              return Vector<2>{3, -4};
                                            }),
                             whole * 25 / 2, 1e-13);
}

TEUCHOS_UNIT_TEST(BlockMass, ARotationHasTheEnergyOfTheMomentOfInertiaWhenConsistent) {
  const auto about_centre = [](const Vector<2>& x) { return Vector<2>{-(x[1] - side / 2), x[0] - side / 2}; };
  const double exact = whole * (side * side + side * side) / 12 / 2;
  for (const bool triangles : {false, true})  // velocities are linear in space: the shape functions hold them exactly
    TEST_FLOATING_EQUALITY(kinetic_energy(square(triangles), Mass::consistent, about_centre), exact, 1e-12);
  // Lumped mass stands farther out: each cell adds its own moment, h^2/6 of its mass, once more or so.
  TEST_COMPARE(kinetic_energy(square(false), Mass::lumped, about_centre), >, 1.05 * exact);
  TEST_COMPARE(kinetic_energy(square(false), Mass::lumped, about_centre), <, 1.5 * exact);
}

TEUCHOS_UNIT_TEST(BlockMass, IsSymmetricAndPositiveAndDiagonalWhenLumped) {
  for (const auto kind : {Mass::consistent, Mass::lumped}) {
    const auto m = block_mass(square(true), density, thickness, kind);
    std::vector<std::vector<double>> full(m.rows(), std::vector<double>(m.rows(), 0.0));
    for (int i = 0; i < m.rows(); ++i)
      for (int k = m.start[i]; k < m.start[i + 1]; ++k) full[i][m.column[k]] = m.value[k];
    for (int i = 0; i < m.rows(); ++i) {
      TEST_COMPARE(full[i][i], >, 0);
      for (int j = 0; j < i; ++j) {
        TEST_COMPARE(std::abs(full[i][j] - full[j][i]), <=, 1e-15 * whole);
        if (kind == Mass::lumped) TEST_EQUALITY(full[i][j], 0);
        if (i % 2 != j % 2) TEST_EQUALITY(full[i][j], 0);  // motions along x and y do not push each other
      }
    }
  }
}

}  // namespace
