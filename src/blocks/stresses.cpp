#include "blocks/stresses.hpp"

#include "blocks/assembly.hpp"
#include "blocks/element_matrices.hpp"
#include "blocks/solid_matrices.hpp"

namespace voussoir {
namespace {

std::array<double, 3> stress_of(const Structure<2>& s, const LocalBlock<2>& block, const Cell& cell,
                                const std::array<Vector<2>, 4>& u, double free_strain) {
  const auto plane = s.model().plane;
  const auto d = plane_elasticity(block.material, plane);
  const double free = free_strain * (d[0][0] + d[0][1]);
  const auto value = element_stress(cell, cell_positions(block.mesh, cell), u, block.material, plane);
  return {value[0] - free, value[1] - free, value[2]};
}

std::array<double, 6> stress_of(const Structure<3>&, const LocalBlock<3>& block, const Cell& cell,
                                const std::array<Vector<3>, 8>& u, double free_strain) {
  const auto& m = block.material;
  const double free = free_strain * m.young_modulus / (1 - 2 * m.poisson_ratio);
  auto value = solid_stress(cell, cell_positions(block.mesh, cell), u, m);
  for (const int c : {0, 3, 5}) value[c] -= free;
  return value;
}

}  // namespace

template <int dim>
std::vector<double> cell_stresses(const Structure<dim>& s, const std::vector<double>& displacement,
                                  const std::vector<double>& free_strain) {
  std::vector<double> stress;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    for (const auto& cell : block.mesh.cells) {
      std::array<Vector<dim>, 4 * (dim - 1)> u{};
      for (int i = 0; i < cell.count; ++i)
        for (int c = 0; c < dim; ++c) u[i][c] = displacement[dim * (block.first_local + cell.node[i]) + c];
      const auto value = stress_of(s, block, cell, u, free_strain.empty() ? 0.0 : free_strain[b]);
      stress.insert(stress.end(), value.begin(), value.end());
    }
  }
  return stress;
}

template std::vector<double> cell_stresses<2>(const Structure<2>&, const std::vector<double>&,
                                              const std::vector<double>&);
template std::vector<double> cell_stresses<3>(const Structure<3>&, const std::vector<double>&,
                                              const std::vector<double>&);

}  // namespace voussoir
