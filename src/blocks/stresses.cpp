#include "blocks/stresses.hpp"

#include <utility>

#include "blocks/assembly.hpp"
#include "blocks/block_forces.hpp"
#include "blocks/condensed_edges.hpp"
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

/// Adds what edges add that bend. A free strain bends none.
/// @param stress  of the cells of the block
template <int dim>
void add_stress_of_edges(const Structure<dim>& s, const LocalBlock<dim>& block, const std::vector<double>& displacement,
                         double free_strain, std::vector<double> edge_force, double* stress) {
  if (!block.edges) return;
  const auto elasticity = dim == 2 ? lame(block.material, s.model().plane) : lame(block.material);
  auto u = free_displacement(block, free_strain);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = displacement[dim * static_cast<std::size_t>(block.first_local) + i] - u[i];
  const auto bends = block.edges->bends(block.mesh, u, std::move(edge_force));
  for (std::size_t n = 0; n < block.mesh.cells.size(); ++n) {
    const auto& cell = block.mesh.cells[n];
    if (cell.count != Simplex<dim>::corners) continue;
    typename Simplex<dim>::Places x{};
    for (int i = 0; i < Simplex<dim>::corners; ++i) x[i] = block.mesh.position[cell.node[i]];
    const auto more = stress_of(elasticity, edge_slope(Simplex<dim>(x), bends[n]));
    for (std::size_t c = 0; c < more.size(); ++c) stress[more.size() * n + c] += more[c];
  }
}

}  // namespace

template <int dim>
std::vector<double> cell_stresses(const Structure<dim>& s, const std::vector<double>& displacement,
                                  const InnerLoads& inner) {
  std::vector<double> stress;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    const std::size_t first = stress.size();
    const double free_strain = inner.free_strain.empty() ? 0.0 : inner.free_strain[b];
    for (const auto& cell : block.mesh.cells) {
      std::array<Vector<dim>, 4 * (dim - 1)> u{};
      for (int i = 0; i < cell.count; ++i)
        for (int c = 0; c < dim; ++c) u[i][c] = displacement[dim * (block.first_local + cell.node[i]) + c];
      const auto value = stress_of(s, block, cell, u, free_strain);
      stress.insert(stress.end(), value.begin(), value.end());
    }
    add_stress_of_edges(s, block, displacement, free_strain, forces_of_edges(s, b, inner.edge_force),
                        stress.data() + first);
  }
  return stress;
}

template std::vector<double> cell_stresses<2>(const Structure<2>&, const std::vector<double>&, const InnerLoads&);
template std::vector<double> cell_stresses<3>(const Structure<3>&, const std::vector<double>&, const InnerLoads&);

}  // namespace voussoir
