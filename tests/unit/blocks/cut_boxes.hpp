// Boxes of cubes that are cut into six tetrahedra each, and rectangles of squares that are cut into two triangles.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "blocks/condensed_edges.hpp"
#include "mesh/lattice.hpp"
#include "mesh/mesh.hpp"

namespace voussoir::test {

/// A box of n[0] x n[1] x n[2] cubes of side h from a corner on; coincident nodes of two of them have the same vertex.
inline Block<3> box(BlockId id, const std::array<int, 3>& n, double h, const std::array<int, 3>& from = {}) {
  Block<3> block;
  block.id = id;
  block.name = "box " + std::to_string(id);
  const auto node = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        block.position.push_back({h * (from[0] + i), h * (from[1] + j), h * (from[2] + k)});
        block.vertex.push_back(((from[2] + k) * 100LL + from[1] + j) * 100 + from[0] + i);
      }
  const std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}};
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        for (std::size_t o = 0; o < orders.size();
             ++o) {  // along the edges of a cube, from its corner to the one across
          std::array<int, 3> at{i, j, k};
          Cell cell{{node(i, j, k)}, 4};
          for (int step = 0; step < 3; ++step) {
            ++at[orders[o][step]];
            cell.node[step + 1] = node(at[0], at[1], at[2]);
          }
          if (o >= 3) std::swap(cell.node[1], cell.node[2]);
          block.cells.push_back(cell);
        }
  return block;
}

/// across x up squares of side h from a corner on; its lowest edges are of the set 0, its right ones of the set 1.
inline Block<2> rectangle_of_triangles(BlockId id, int across, int up, double h, int from = 0) {
  Block<2> block;
  block.id = id;
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i <= across; ++i) {
      block.position.push_back({h * (from + i), h * j});
      block.vertex.push_back(100 * j + from + i);
    }
  block.cells = lattice_cells(across, up, CellType::quadratic_triangle);
  add_lattice_facets(block, across, up, LatticeSide::bottom, 0);
  add_lattice_facets(block, across, up, LatticeSide::left, 1);
  return block;
}

/// On the edges of a block, of a uniform force on all of it [N/m3].
template <int dim>
std::vector<double> body_force(const CondensedEdges& edges, const Vector<dim>& per_volume) {
  std::vector<double> force(dim * static_cast<std::size_t>(edges.size()), 0.0);
  edges.add_body_force<dim>(per_volume, force.data());
  return force;
}

}  // namespace voussoir::test
