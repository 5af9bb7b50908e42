// Cells and meshes of one block against elasticity in closed form: rigid motions, uniform strain, volumes.
#include "blocks/element_matrices.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <numeric>

#include "linalg/sparse_cholesky.hpp"
#include "unit/blocks/lattice_block.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

using Corners = std::array<Vector<2>, 4>;

const Material stone{2.5, 0.3, 1.0};  // numbers near 1, so that absolute tolerances mean relative ones
constexpr double thickness = 0.7;

struct Shape {
  Cell cell;
  Corners x;
};

Shape triangle() { return {{{0, 1, 2}, 3}, {{{0.1, 0.0}, {1.3, 0.2}, {0.4, 1.1}}}}; }
Shape quadrilateral() { return {{{0, 1, 2, 3}, 4}, {{{0.0, 0.0}, {2.0, 0.3}, {1.7, 1.6}, {-0.2, 1.1}}}}; }

/// Displacement whose gradient is the same everywhere: strain (xx, yy, 2 xy) = (3, -2, 4) and a rotation.
Vector<2> uniform_strain(const Vector<2>& x) { return {0.5 + 3 * x[0] + 1.5 * x[1], -1.0 + 2.5 * x[0] - 2 * x[1]}; }

std::array<double, 3> exact_stress(Plane plane) {
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const double shear = e / (2 * (1 + nu)) * 4;
  if (plane == Plane::stress) {
    const double c = e / (1 - nu * nu);
    return {c * (3 - nu * 2), c * (-2 + nu * 3), shear};
  }
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));  // Lame
  return {lambda * (3 - 2) + 2 * mu * 3, lambda * (3 - 2) - 2 * mu * 2, shear};
}

double area(const Shape& s) {
  double twice = 0;
  for (int i = 0; i < s.cell.count; ++i) twice += cross(s.x[i], s.x[(i + 1) % s.cell.count]);
  return twice / 2;
}

/// A block of 3 x 3 cells of 1 m whose inner nodes, and those along its sides, are moved; triangles halve the cells.
Block<2> distorted_block(bool triangles) {
  auto block = block_of_cells(0, rectangle(0, 0, 3, 3));
  for (auto& x : block.position) {
    const Vector<2> at = x;
    x[0] += 0.2 * std::sin(2 * at[1] + 1) * at[0] * (3 - at[0]) / 2;
    x[1] += 0.2 * std::cos(3 * at[0]) * at[1] * (3 - at[1]) / 2;
  }
  return triangles ? in_triangles(block) : block;
}

TEUCHOS_UNIT_TEST(ElementStiffness, IsSymmetricWithThreeRigidMotionsAndNoOtherFreeMotion) {
  for (const auto plane : {Plane::stress, Plane::strain})
    for (const auto& s : {triangle(), quadrilateral()}) {
      auto k = element_stiffness(s.cell, s.x, stone, plane, thickness);
      const int n = 2 * s.cell.count;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) TEST_COMPARE(std::abs(k[i * n + j] - k[j * n + i]), <=, 1e-15 * 10);
      for (const double rotation : {0.0, 1.0}) {
        std::vector<double> u(n);
        for (int i = 0; i < s.cell.count; ++i) {
          u[2 * i] = 1 - rotation * s.x[i][1];
          u[2 * i + 1] = 2 + rotation * s.x[i][0];
        }
        for (int i = 0; i < n; ++i)  // entries of the size of E, 8 terms each
          TEST_COMPARE(std::abs(std::inner_product(u.begin(), u.end(), k.begin() + i * n, 0.0)), <=, 1e-14);
      }
      std::vector<double> eigenvalue(n), work(10 * n);
      int info = 0;
      Teuchos::LAPACK<int, double>().SYEV('N', 'U', n, k.data(), n, eigenvalue.data(), work.data(), 10 * n, &info);
      TEST_EQUALITY(info, 0);
      TEST_COMPARE(std::abs(eigenvalue[0]), <=, 1e-14);
      TEST_COMPARE(std::abs(eigenvalue[2]), <=, 1e-14);
      // One quadrature point would leave a quadrilateral two hourglass motions of zero energy.
      TEST_COMPARE(eigenvalue[3], >=, 0.01 * eigenvalue[n - 1]);
    }
}

TEUCHOS_UNIT_TEST(ElementStiffness, TheEnergyOfUniformStrainIsHalfStressTimesStrainTimesVolume) {
  for (const auto plane : {Plane::stress, Plane::strain})
    for (const auto& s : {triangle(), quadrilateral()}) {
      const auto k = element_stiffness(s.cell, s.x, stone, plane, thickness);
      const int n = 2 * s.cell.count;
      double energy = 0;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          energy += uniform_strain(s.x[i / 2])[i % 2] * k[i * n + j] * uniform_strain(s.x[j / 2])[j % 2] / 2;
      const auto stress = exact_stress(plane);
      const double exact = (3 * stress[0] - 2 * stress[1] + 4 * stress[2]) / 2 * area(s) * thickness;
      TEST_FLOATING_EQUALITY(energy, exact, 1e-13);  // 64 terms, some cancelling
    }
}

TEUCHOS_UNIT_TEST(ElementStress, IsExactForUniformStrainInPlaneStressAndPlaneStrain) {
  for (const auto plane : {Plane::stress, Plane::strain})
    for (const auto& s : {triangle(), quadrilateral()}) {
      Corners u{};
      for (int i = 0; i < s.cell.count; ++i) u[i] = uniform_strain(s.x[i]);
      const auto stress = element_stress(s.cell, s.x, u, stone, plane), exact = exact_stress(plane);
      for (int c = 0; c < 3; ++c) TEST_FLOATING_EQUALITY(stress[c], exact[c], 1e-13);
    }
}

TEUCHOS_UNIT_TEST(PlaneElasticity, ABarFreeToNarrowFeelsYoungsModulusAndMoreInPlaneStrain) {
  const double e = stone.young_modulus, nu = stone.poisson_ratio;
  const auto modulus = [](Plane plane) {  // xx stress per xx strain at zero yy stress
    const auto d = plane_elasticity(stone, plane);
    return d[0][0] - d[0][1] * d[1][0] / d[1][1];
  };
  TEST_FLOATING_EQUALITY(modulus(Plane::stress), e, 1e-15);
  TEST_FLOATING_EQUALITY(modulus(Plane::strain), e / (1 - nu * nu), 1e-15);
}

TEUCHOS_UNIT_TEST(BlockStiffness, PassesThePatchTestOnDistortedMeshesOfBothCells) {
  // Border nodes are moved as in uniform strain; the inner ones must follow it exactly, whatever the mesh.
  for (const auto plane : {Plane::stress, Plane::strain})
    for (const bool triangles : {false, true}) {
      const auto block = distorted_block(triangles);
      const auto k = block_stiffness(block, stone, plane, thickness);
      std::vector<int> free_number(k.rows(), -1);
      int count = 0;
      for (int j = 1; j < 3; ++j)
        for (int i = 1; i < 3; ++i)
          for (std::size_t n = 0; n < block.vertex.size(); ++n)
            if (block.vertex[n] == 1000LL * (j + 100) + i + 100)
              for (int c = 0; c < 2; ++c) free_number[2 * n + c] = count++;
      TEST_EQUALITY(count, 8);
      LocalCsr inner;
      std::vector<int> row_of(count);
      for (int row = 0; row < k.rows(); ++row)
        if (free_number[row] >= 0) row_of[free_number[row]] = row;
      std::vector<double> b(count, 0.0);
      for (int r = 0; r < count; ++r) {
        std::map<int, double> entries;
        for (int e = k.start[row_of[r]]; e < k.start[row_of[r] + 1]; ++e) {
          const int column = k.column[e];
          if (free_number[column] >= r)
            entries[free_number[column]] = k.value[e];
          else if (free_number[column] < 0)
            b[r] -= k.value[e] * uniform_strain(block.position[column / 2])[column % 2];
        }
        for (const auto& [column, value] : entries) {
          inner.column.push_back(column);
          inner.value.push_back(value);
        }
        inner.start.push_back(static_cast<int>(inner.column.size()));
      }
      std::vector<double> x(count);
      SparseCholesky(inner).solve(b.data(), x.data());
      // Displacements of about 5, condition of some tens.
      for (int r = 0; r < count; ++r)
        TEST_COMPARE(std::abs(x[r] - uniform_strain(block.position[row_of[r] / 2])[row_of[r] % 2]), <=, 1e-12);
    }
}

TEUCHOS_UNIT_TEST(ElementVolumes, SumToAreaTimesThicknessAndKeepTheCentroid) {
  for (const auto& s : {triangle(), quadrilateral()}) {
    const auto volume = element_volumes(s.cell, s.x, thickness);
    double sum = 0;
    Vector<2> moment{}, exact{};
    for (int i = 0; i < s.cell.count; ++i) {
      const auto& next = s.x[(i + 1) % s.cell.count];
      sum += volume[i];
      moment = moment + volume[i] * s.x[i];
      exact = exact + thickness * cross(s.x[i], next) / 6 * (s.x[i] + next);
    }
    TEST_FLOATING_EQUALITY(sum, area(s) * thickness, 1e-14);
    for (int c = 0; c < 2; ++c) TEST_FLOATING_EQUALITY(moment[c], exact[c], 1e-14);
  }
}

TEUCHOS_UNIT_TEST(NodalVolumes, SumToTheVolumeOfTheBlock) {
  for (const bool triangles : {false, true}) {
    auto block = distorted_block(triangles);
    double exact = 0;
    for (const auto& cell : block.cells) exact += area({cell, cell_positions(block, cell)}) * thickness;
    const auto volume = nodal_volumes(block, thickness);
    TEST_EQUALITY(volume.size(), block.position.size());
    TEST_FLOATING_EQUALITY(std::accumulate(volume.begin(), volume.end(), 0.0), exact, 1e-14);
  }
}

}  // namespace
