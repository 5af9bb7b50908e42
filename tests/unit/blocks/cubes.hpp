// Two unit cubes of hexahedra, one on top of the other, turned to lie along no axis of space.
#pragma once

#include <memory>
#include <utility>

#include "blocks/structure.hpp"
#include "mesh/block_list.hpp"
#include "mesh/partition.hpp"

namespace voussoir::test {

/// A rotation of space, by 0.5 about z and then by 0.7 about x.
inline Vector<3> turned(const Vector<3>& x) {
  const auto about_z = Rotation<2>(0.5)(Vector<2>{x[0], x[1]});
  const auto about_x = Rotation<2>(0.7)(Vector<2>{about_z[1], x[2]});
  return {about_z[0], about_x[0], about_x[1]};
}

/// Cube `storey` of n x n x n cells, before it is turned. Coincident nodes of two cubes have the same vertex.
inline Block<3> cube(int storey, int n) {
  Block<3> block;
  block.id = storey;
  const auto node = [n](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        block.position.push_back({double(i) / n, double(j) / n, storey + double(k) / n});
        block.vertex.push_back(node(i, j, k + storey * n));
      }
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::array<int, 4> below{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)};
        Cell cell;
        cell.count = 8;
        for (int corner = 0; corner < 4; ++corner) {
          cell.node[corner] = below[corner];
          cell.node[corner + 4] = below[corner] + (n + 1) * (n + 1);
        }
        block.cells.push_back(cell);
      }
  return block;
}

inline std::unique_ptr<BlockSource<3>> two_cubes(int n) {
  BlockList<3> list;
  for (int storey : {0, 1}) {
    list.blocks.push_back(cube(storey, n));
    for (auto& x : list.blocks.back().position) x = turned(x);
  }
  return make_source(std::move(list));
}

/// E = 1e9 Pa, nu = 0.2.
inline Structure<3> structure_of(const BlockSource<3>& source, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  return Structure<3>(
      source, share_out(source, *comm), {},
      [](const Block<3>&) {
        return Material{1e9, 0.2, 2000};
      },
      comm);
}

}  // namespace voussoir::test
