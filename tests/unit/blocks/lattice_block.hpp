// Blocks put together from the cells of a square lattice, and structures made of blocks, for tests.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "blocks/assembly.hpp"
#include "blocks/structure.hpp"
#include "mesh/block_list.hpp"
#include "mesh/generators.hpp"
#include "mesh/partition.hpp"

namespace voussoir::test {

/// A block of square cells (i, j) of side h [m]; coincident nodes of two such blocks have the same vertex.
inline Block<2> block_of_cells(BlockId id, const std::vector<std::array<int, 2>>& cells, double h = 1.0) {
  Block<2> block;
  block.id = id;
  block.name = "block " + std::to_string(id);
  std::map<std::array<int, 2>, int> number;
  const auto node = [&](int i, int j) {
    const auto [it, added] = number.emplace(std::array<int, 2>{i, j}, static_cast<int>(block.position.size()));
    if (added) {
      block.position.push_back({h * i, h * j});
      block.vertex.push_back(1000LL * (j + 100) + i + 100);
    }
    return it->second;
  };
  for (const auto& [i, j] : cells) {
    Cell cell;
    cell.count = 4;
    cell.node = {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
    block.cells.push_back(cell);
  }
  return block;
}

/// Cells of a rectangle, nx x ny of them from (i, j) on.
inline std::vector<std::array<int, 2>> rectangle(int i, int j, int nx, int ny) {
  std::vector<std::array<int, 2>> cells;
  for (int y = j; y < j + ny; ++y)
    for (int x = i; x < i + nx; ++x) cells.push_back({x, y});
  return cells;
}

/// E = 1e9 Pa, nu = 0.2, density 2000 kg/m3; blocks divided as the program does.
inline Structure<2> structure_of(const BlockSource<2>& source, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                 const ModelParameters& model = {}, const Material& material = {1e9, 0.2, 2000}) {
  return Structure<2>(
      source, share_out(source, *comm), model, [material](const Block<2>&) { return material; }, comm);
}

/// The same block with each of its quadrilaterals cut into two triangles.
inline Block<2> in_triangles(Block<2> block) {
  std::vector<Cell> halves;
  for (const auto& c : block.cells) {
    halves.push_back({{c.node[0], c.node[1], c.node[2]}, 3});
    halves.push_back({{c.node[0], c.node[2], c.node[3]}, 3});
  }
  block.cells = halves;
  return block;
}

}  // namespace voussoir::test
