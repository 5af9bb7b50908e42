#include "mesh/lattice.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/text.hpp"

namespace voussoir {

std::vector<Cell> lattice_cells(int across, int up, CellType type) {
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(across) * up * (type == CellType::quadrilateral ? 1 : 2));
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < across; ++i) {
      const int a = j * (across + 1) + i, b = a + 1, d = a + across + 1, c = d + 1;
      if (type == CellType::quadrilateral) {
        cells.push_back({{a, b, c, d}, 4});
      } else if ((i + j) % 2 == 0) {
        cells.push_back({{a, b, c}, 3});
        cells.push_back({{a, c, d}, 3});
      } else {
        cells.push_back({{a, b, d}, 3});
        cells.push_back({{b, c, d}, 3});
      }
    }
  return cells;
}

void add_lattice_facets(Block<2>& block, int across, int up, LatticeSide side, int set) {
  const auto node = [across](int i, int j) { return j * (across + 1) + i; };
  const bool along_x = side == LatticeSide::bottom || side == LatticeSide::top;
  const int count = along_x ? across : up;
  for (int k = 0; k < count; ++k) {
    const int back = count - k;
    TaggedFacet facet;
    facet.count = 2;
    facet.set = set;
    switch (side) {
      case LatticeSide::bottom:
        facet.node = {node(k, 0), node(k + 1, 0)};
        break;
      case LatticeSide::right:
        facet.node = {node(across, k), node(across, k + 1)};
        break;
      case LatticeSide::top:
        facet.node = {node(back, up), node(back - 1, up)};
        break;
      case LatticeSide::left:
        facet.node = {node(0, back), node(0, back - 1)};
        break;
    }
    block.facets.push_back(facet);
  }
}

namespace {

/// Of a box of cells.
int box_node(const std::array<int, 3>& cells, const std::array<int, 3>& at) {
  return (at[2] * (cells[1] + 1) + at[1]) * (cells[0] + 1) + at[0];
}

}  // namespace

std::vector<Cell> box_cells(const std::array<int, 3>& n) {
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(n[0]) * n[1] * n[2]);
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const auto node = [&](int a, int b, int c) { return box_node(n, {i + a, j + b, k + c}); };
        cells.push_back({{node(0, 0, 0), node(1, 0, 0), node(1, 1, 0), node(0, 1, 0), node(0, 0, 1), node(1, 0, 1),
                          node(1, 1, 1), node(0, 1, 1)},
                         8});
      }
  return cells;
}

void add_box_facets(Block<3>& block, const std::array<int, 3>& n, int axis, bool far, int set,
                    const std::function<bool(int, int)>& wanted) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;  // axis, u, v: right-handed
  for (int j = 0; j < n[v]; ++j)
    for (int i = 0; i < n[u]; ++i) {
      if (!wanted(i, j)) continue;
      const auto node = [&](int a, int b) {
        std::array<int, 3> at{};
        at[axis] = far ? n[axis] : 0;
        at[u] = i + a;
        at[v] = j + b;
        return box_node(n, at);
      };
      TaggedFacet facet;
      facet.count = 4;
      facet.set = set;
      facet.node = {node(0, 0), far ? node(1, 0) : node(0, 1), node(1, 1), far ? node(0, 1) : node(1, 0)};
      block.facets.push_back(facet);
    }
}

std::string in_words(double value) { return six_digits(value); }

void refuse_mesh(const std::string& key, const std::string& value, const std::string& why, const std::string& advice) {
  throw InputError("mesh > " + key + " = " + value + "\n  " + why + "\n  " + advice);
}

void require_positive(const std::string& key, double value, const std::string& unit) {
  if (!(std::isfinite(value) && value > 0))
    refuse_mesh(key, in_words(value) + " [" + unit + "]", "must be a finite number > 0.",
                "Give the size in " + (unit == "degree" ? std::string("degrees.") : std::string("metres.")));
}

void require_countable(const std::string& key, int courses, double blocks, double lines) {
  if (blocks <= std::numeric_limits<BlockId>::max() && lines <= 1e9) return;
  refuse_mesh(
      key, std::to_string(courses) + " [-]",
      "makes about " + in_words(blocks) + " blocks or over 1e9 lattice lines, more than numbers here can count.",
      "Make the wall smaller or the cells larger.");
}

void require_at_least(const std::string& key, int value, int least) {
  if (value < least)
    refuse_mesh(key, std::to_string(value) + " [-]", "must be >= " + std::to_string(least) + ".",
                "Count blocks and cells in whole numbers from " + std::to_string(least) + " upward.");
}

}  // namespace voussoir
