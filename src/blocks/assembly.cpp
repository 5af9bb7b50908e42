#include "blocks/assembly.hpp"

#include <algorithm>
#include <set>

#include "blocks/element_matrices.hpp"

namespace voussoir {

std::array<Vector<2>, 4> cell_positions(const Block<2>& block, const Cell& cell) {
  std::array<Vector<2>, 4> x{};
  for (int i = 0; i < cell.count; ++i) x[i] = block.position[cell.node[i]];
  return x;
}

LocalCsr block_stiffness(const Block<2>& block, const Material& material, Plane plane, double thickness) {
  const int nodes = static_cast<int>(block.position.size());
  std::vector<std::vector<int>> neighbours(nodes);
  for (const auto& cell : block.cells)
    for (int i = 0; i < cell.count; ++i)
      for (int j = 0; j < cell.count; ++j) neighbours[cell.node[i]].push_back(cell.node[j]);

  LocalCsr k;
  for (auto& row : neighbours) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    for (int component = 0; component < 2; ++component) {
      for (int j : row) k.column.insert(k.column.end(), {2 * j, 2 * j + 1});
      k.start.push_back(k.column.size());
    }
  }
  k.value.assign(k.column.size(), 0.0);

  for (const auto& cell : block.cells) {
    const auto ke = element_stiffness(cell, cell_positions(block, cell), material, plane, thickness);
    const int n = 2 * cell.count;
    for (int i = 0; i < n; ++i) {
      const int row = 2 * cell.node[i / 2] + i % 2;
      for (int j = 0; j < n; ++j) {
        const int column = 2 * cell.node[j / 2] + j % 2;
        const auto first = k.column.begin() + static_cast<long>(k.start[row]);
        const auto last = k.column.begin() + static_cast<long>(k.start[row + 1]);
        k.value[std::lower_bound(first, last, column) - k.column.begin()] += ke[i * n + j];
      }
    }
  }
  return k;
}

std::vector<double> nodal_volumes(const Block<2>& block, double thickness) {
  std::vector<double> volume(block.position.size(), 0.0);
  for (const auto& cell : block.cells) {
    const auto share = element_volumes(cell, cell_positions(block, cell), thickness);
    for (int i = 0; i < cell.count; ++i) volume[cell.node[i]] += share[i];
  }
  return volume;
}

}  // namespace voussoir
