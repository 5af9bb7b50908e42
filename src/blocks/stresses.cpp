#include "blocks/stresses.hpp"

#include "blocks/assembly.hpp"
#include "blocks/element_matrices.hpp"

namespace voussoir {

std::vector<double> cell_stresses(const Structure<2>& s, const std::vector<double>& displacement,
                                  const std::vector<double>& free_strain) {
  const auto plane = s.model().plane;
  std::vector<double> stress;
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.blocks()[b];
    const auto d = plane_elasticity(block.material, plane);
    const double free = free_strain.empty() ? 0.0 : free_strain[b] * (d[0][0] + d[0][1]);
    for (const auto& cell : block.mesh.cells) {
      std::array<Vector<2>, 4> u{};
      for (int i = 0; i < cell.count; ++i)
        for (int c = 0; c < 2; ++c) u[i][c] = displacement[2 * (block.first_local + cell.node[i]) + c];
      const auto value = element_stress(cell, cell_positions(block.mesh, cell), u, block.material, plane);
      stress.insert(stress.end(), {value[0] - free, value[1] - free, value[2]});
    }
  }
  return stress;
}

}  // namespace voussoir
