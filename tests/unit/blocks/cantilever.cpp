// Bending of bars of hexahedra against the theory of beams: what cells with modes of their own are for.
//
// Set-up    A bar of 1 x 0.1 x 0.1 m, held at its left end as a beam is, a force up along its right end.
// Measured  Its deflection there, over that of a beam with its bending and its shear (6/5 of the area).
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "blocks/assembly.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace {

using namespace voussoir;

constexpr double length = 1, side = 0.1;
const Material stone{1e9, 0.2, 0};

Block<3> bar(int along, int across) {
  Block<3> block;
  const auto node = [&](int i, int j, int k) { return (i * (across + 1) + j) * (across + 1) + k; };
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      for (int k = 0; k <= across; ++k)
        block.position.push_back({length * i / along, side * j / across, side * k / across});
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k < across; ++k)
        block.cells.push_back(
            {{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
              node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)},
             8});
  return block;
}

/// Share of the end that a node at its border stands for, twice that for others.
double share_of(double x) { return x < 1e-9 || x > side - 1e-9 ? 0.5 : 1.0; }

double deflection(int along, int across, Hexahedra kind) {
  const auto block = bar(along, across);
  const auto k = block_stiffness(block, stone, kind);
  std::vector<int> number(k.rows(), -1);
  std::vector<double> force;
  for (int i = 0; i < k.rows(); ++i) {
    const auto& x = block.position[i / 3];
    const bool held = x[0] == 0 && (i % 3 != 1 || x[1] == 0);  // the end may become wider and narrower
    if (held) continue;
    number[i] = static_cast<int>(force.size());
    const bool end = i % 3 == 2 && x[0] == length;
    force.push_back(end ? share_of(x[1]) * share_of(x[2]) / (across * across) : 0.0);
  }
  LocalCsr free;
  for (int i = 0; i < k.rows(); ++i) {
    if (number[i] < 0) continue;
    for (int e = k.start[i]; e < k.start[i + 1]; ++e)
      if (number[k.column[e]] >= number[i]) {
        free.column.push_back(number[k.column[e]]);
        free.value.push_back(k.value[e]);
      }
    free.start.push_back(static_cast<int>(free.column.size()));
  }
  std::vector<double> u(force.size());
  SparseCholesky(free).solve(force.data(), u.data());
  double work = 0;  // of a force of 1 N: the mean deflection of the end
  for (std::size_t i = 0; i < u.size(); ++i) work += force[i] * u[i];
  const double inertia = std::pow(side, 4) / 12, shear = stone.young_modulus / (2 * (1 + stone.poisson_ratio));
  const double beam = std::pow(length, 3) / (3 * stone.young_modulus * inertia) + 1.2 * length / (shear * side * side);
  return work / beam;
}

// A mesh that has few cells is a few thousandths off, whatever bends; the digits are those of the mesh, told to 0.001.
TEUCHOS_UNIT_TEST(Cantilever, BendsAsABeamDoesOfOneCellInThickness) {
  TEST_COMPARE(std::abs(deflection(10, 1, Hexahedra::incompatible) - 0.994), <=, 1e-3);
  TEST_COMPARE(std::abs(deflection(5, 1, Hexahedra::incompatible) - 0.985), <=, 1e-3);
  TEST_COMPARE(std::abs(deflection(20, 2, Hexahedra::incompatible) - 0.995), <=, 1e-3);
}

TEUCHOS_UNIT_TEST(Cantilever, OfPlainCellsIsTooStiffByAThirdAndMore) {
  TEST_COMPARE(deflection(10, 1, Hexahedra::plain), <, 0.7);
  TEST_COMPARE(deflection(5, 1, Hexahedra::plain), <, 0.4);
}

// Cells of a tenth of the thickness and more come to the same from both sides.
TEUCHOS_UNIT_TEST(Cantilever, OfManyCellsIsOneForBothKinds) {
  const double plain = deflection(40, 4, Hexahedra::plain), modes = deflection(40, 4, Hexahedra::incompatible);
  TEST_COMPARE(plain, <, modes);
  TEST_COMPARE(modes - plain, <, 0.03);
}

}  // namespace
