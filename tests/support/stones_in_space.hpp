// Structures of hexahedral stones in space whose nodes match, on blocks of ground: a prism, walls with returns, a dome.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "mesh/block_list.hpp"

namespace voussoir::test {

/// A stone in cells of a lattice, from low to high.
struct LatticeStone {
  std::array<int, 3> low, high;
  bool ground = false;
};

struct StonesInSpace {
  BlockList<3> list;
  std::vector<char> ground;  ///< per block
};

/// @param place   [m] of a node of the lattice, as a node of a stone
/// @param around  cells after which the second direction closes; 0 where it does not
inline StonesInSpace on_lattice(const std::vector<LatticeStone>& stones,
                                const std::function<Vector<3>(const LatticeStone&, int, int, int)>& place,
                                int around = 0) {
  constexpr VertexId most = 1000;  // nodes of the lattice along any direction
  StonesInSpace scene;
  for (const auto& s : stones) {
    Block<3> b;
    b.id = BlockId(scene.list.blocks.size());
    std::array<int, 3> n;
    for (int c = 0; c < 3; ++c) n[c] = s.high[c] - s.low[c] + 1;
    for (int k = s.low[2]; k <= s.high[2]; ++k)
      for (int j = s.low[1]; j <= s.high[1]; ++j)
        for (int i = s.low[0]; i <= s.high[0]; ++i) {
          b.position.push_back(place(s, i, j, k));
          b.vertex.push_back(((k + 1) * most + (around > 0 ? j % around : j)) * most + i);
        }
    const auto node = [&](int i, int j, int k) { return (k * n[1] + j) * n[0] + i; };
    for (int k = 0; k + 1 < n[2]; ++k)
      for (int j = 0; j + 1 < n[1]; ++j)
        for (int i = 0; i + 1 < n[0]; ++i) {
          Cell cell;
          cell.count = 8;
          const std::array<int, 4> below{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)};
          for (int q = 0; q < 4; ++q) {
            cell.node[q] = below[q];
            cell.node[q + 4] = below[q] + n[0] * n[1];
          }
          b.cells.push_back(cell);
        }
    scene.list.blocks.push_back(std::move(b));
    scene.ground.push_back(s.ground);
  }
  return scene;
}

/// A regular lattice, with ground below every stone that stands on its lowest plane.
inline StonesInSpace on_ground(const std::vector<LatticeStone>& stones, const Vector<3>& cell) {
  std::vector<LatticeStone> all;
  for (const auto& s : stones)
    if (s.low[2] == 0) all.push_back({{s.low[0], s.low[1], -1}, {s.high[0], s.high[1], 0}, true});
  all.insert(all.end(), stones.begin(), stones.end());
  return on_lattice(all, [cell](const LatticeStone&, int i, int j, int k) {
    return Vector<3>{cell[0] * i, cell[1] * j, cell[2] * k};
  });
}

/// One prism of this size [m], so many cells a side.
inline StonesInSpace prism(const Vector<3>& size, int cells) {
  return on_ground({{{0, 0, 0}, {cells, cells, cells}}}, (1.0 / cells) * size);
}

/// A dry wall of stones 0.4 x 0.2 x 0.2 m, so many cells in 0.2 m: a facade of so many stones, and at none, one or both
/// of its ends a return. Even courses of the facade have the corner, returns start behind it.
inline StonesInSpace wall_with_returns(int facade, int along_return, int courses, int returns, int cells) {
  std::vector<LatticeStone> stones;
  const auto box = [&](int x0, int x1, int y0, int y1, int k) {
    stones.push_back({{x0 * cells, y0 * cells, k * cells}, {x1 * cells, y1 * cells, (k + 1) * cells}});
  };
  const int length = 2 * facade, depth = 2 * along_return;  // in halves of a stone
  for (int k = 0; k < courses; ++k) {
    const bool even = k % 2 == 0;
    const int end = even || returns < 2 ? length : length - 1;
    if (!even && returns == 0) box(0, 1, 0, 1, k);
    for (int x = even ? 0 : 1; x < end; x += 2) box(x, std::min(x + 2, end), 0, 1, k);
    for (int side = 0; side < returns; ++side) {
      const int x = side == 0 ? 0 : length - 1;
      for (int y = even ? 1 : 0; y < depth; y += 2) box(x, x + 1, y, std::min(y + 2, depth), k);
    }
  }
  return on_ground(stones, {0.2 / cells, 0.2 / cells, 0.2 / cells});
}

/// A dome of lunes and courses, from an eye at `top` [rad] from the zenith to its springing; faces of stones are plane.
/// @param thickness  relative to the radius, 5 m
inline StonesInSpace dome(int lunes, int courses, double thickness, double top, int cells) {
  const double quarter = std::acos(0.0), radius = 5, step = (quarter - top) / courses;
  std::vector<LatticeStone> stones;  // through the thickness, around, from the springing up
  for (int k = -1; k < courses; ++k)
    for (int j = 0; j < lunes; ++j)
      stones.push_back(
          {{0, j * cells, k < 0 ? -1 : k * cells}, {cells, (j + 1) * cells, k < 0 ? 0 : (k + 1) * cells}, k < 0});
  const auto at = [](double r, double p, double a) {
    return Vector<3>{r * std::sin(p) * std::cos(a), r * std::sin(p) * std::sin(a), r * std::cos(p)};
  };
  return on_lattice(
      stones,
      [=](const LatticeStone& s, int i, int j, int k) {
        const double lune = 4 * quarter / lunes, a = lune * (s.low[1] / cells);
        const double height = s.ground ? step / cells : step;
        const double p = s.ground ? quarter + height : quarter - step * (s.low[2] / cells);
        const double through = double(i) / cells, along = double(j - s.low[1]) / cells;
        const double up = double(k - s.low[2]) / (s.high[2] - s.low[2]);
        Vector<3> x{};
        for (int corner = 0; corner < 8; ++corner) {
          const bool out = corner & 1, next = corner & 2, high = corner & 4;
          const double share = (out ? through : 1 - through) * (next ? along : 1 - along) * (high ? up : 1 - up);
          x = x + share * at(radius * (1 + (out ? 0.5 : -0.5) * thickness), high ? p - height : p, next ? a + lune : a);
        }
        return x;
      },
      lunes * cells);
}

}  // namespace voussoir::test
