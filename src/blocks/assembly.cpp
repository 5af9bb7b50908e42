#include "blocks/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "blocks/element_matrices.hpp"
#include "blocks/solid_matrices.hpp"

namespace voussoir {

std::array<Vector<2>, 4> cell_positions(const Block<2>& block, const Cell& cell) {
  std::array<Vector<2>, 4> x{};
  for (int i = 0; i < cell.count; ++i) x[i] = block.position[cell.node[i]];
  return x;
}

std::array<Vector<3>, 8> cell_positions(const Block<3>& block, const Cell& cell) {
  std::array<Vector<3>, 8> x{};
  for (int i = 0; i < cell.count; ++i) x[i] = block.position[cell.node[i]];
  return x;
}

namespace {

/// Rows and columns of a block's matrices: nodes of the same cell are coupled, in all components. Values are 0.
template <int dim>
LocalCsr coupled_nodes(const Block<dim>& block) {
  std::vector<std::vector<int>> neighbours(block.position.size());
  for (const auto& cell : block.cells)
    for (int i = 0; i < cell.count; ++i)
      for (int j = 0; j < cell.count; ++j) neighbours[cell.node[i]].push_back(cell.node[j]);

  LocalCsr k;
  for (auto& row : neighbours) {
    sort_unique(row);
    for (int component = 0; component < dim; ++component) {
      for (int j : row)
        for (int c = 0; c < dim; ++c) k.column.push_back(dim * j + c);
      k.start.push_back(static_cast<int>(k.column.size()));
    }
  }
  k.value.assign(k.column.size(), 0.0);
  return k;
}

/// @param of_cell  stiffness of a cell, row-major, rows node by node
template <int dim, class OfCell>
LocalCsr sum_of_cells(const Block<dim>& block, const OfCell& of_cell) {
  LocalCsr k = coupled_nodes(block);
  for (const auto& cell : block.cells) {
    const auto ke = of_cell(cell);
    const int n = dim * cell.count;
    const auto row = [&](int i) { return dim * cell.node[i / dim] + i % dim; };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) k.at(row(i), row(j)) += ke[i * n + j];
  }
  return k;
}

/// @param products_of  integrals of products of the shape functions of a cell, row-major [m3]
template <int dim, class ProductsOf>
LocalCsr mass_of_cells(const Block<dim>& block, double density, Mass kind, const ProductsOf& products_of) {
  LocalCsr m = coupled_nodes(block);
  for (const auto& cell : block.cells) {
    const auto product = products_of(cell);
    for (int i = 0; i < cell.count; ++i)
      for (int j = 0; j < cell.count; ++j)
        for (int c = 0; c < dim; ++c) {
          const int row = dim * cell.node[i] + c;
          m.at(row, kind == Mass::lumped ? row : dim * cell.node[j] + c) += density * product[i * cell.count + j];
        }
  }
  return m;
}

}  // namespace

LocalCsr block_stiffness(const Block<2>& block, const Material& material, Plane plane, double thickness) {
  return sum_of_cells(block, [&](const Cell& cell) {
    return element_stiffness(cell, cell_positions(block, cell), material, plane, thickness);
  });
}

LocalCsr block_stiffness(const Block<3>& block, const Material& material, Hexahedra kind) {
  return sum_of_cells(
      block, [&](const Cell& cell) { return solid_stiffness(cell, cell_positions(block, cell), material, kind); });
}

LocalCsr block_mass(const Block<2>& block, double density, double thickness, Mass kind) {
  return mass_of_cells(block, density, kind, [&](const Cell& cell) {
    return element_products(cell, cell_positions(block, cell), thickness);
  });
}

LocalCsr block_mass(const Block<3>& block, double density, Mass kind) {
  return mass_of_cells(block, density, kind,
                       [&](const Cell& cell) { return solid_products(cell, cell_positions(block, cell)); });
}

LocalCsr sum(double factor_a, const LocalCsr& a, double factor_b, const LocalCsr& b) {
  VOUSSOIR_CHECK(a.rows() == b.rows());
  LocalCsr c = a;
  for (int i = 0; i < c.rows(); ++i) {
    int of_b = b.start[i];
    for (int k = c.start[i]; k < c.start[i + 1]; ++k) {
      const bool both = of_b < b.start[i + 1] && b.column[of_b] == c.column[k];
      c.value[k] = factor_a * a.value[k] + (both ? factor_b * b.value[of_b++] : 0.0);
    }
    VOUSSOIR_CHECK(of_b == b.start[i + 1]);
  }
  return c;
}

std::vector<double> cell_sizes(const Block<3>& block) {
  std::vector<double> size(block.position.size(), 0.0), cells(size.size(), 0.0);
  for (const auto& cell : block.cells) {
    const auto share = solid_volumes(cell, cell_positions(block, cell));
    const double volume = std::accumulate(share.begin(), share.end(), 0.0);
    for (int i = 0; i < cell.count; ++i) {
      size[cell.node[i]] += volume;
      cells[cell.node[i]] += 1;
    }
  }
  for (std::size_t i = 0; i < size.size(); ++i) size[i] = std::cbrt(size[i] / cells[i]);
  return size;
}

std::vector<double> nodal_volumes(const Block<2>& block, double thickness) {
  std::vector<double> volume(block.position.size(), 0.0);
  for (const auto& cell : block.cells) {
    const auto share = element_volumes(cell, cell_positions(block, cell), thickness);
    for (int i = 0; i < cell.count; ++i) volume[cell.node[i]] += share[i];
  }
  return volume;
}

std::vector<double> nodal_volumes(const Block<3>& block) {
  std::vector<double> volume(block.position.size(), 0.0);
  for (const auto& cell : block.cells) {
    const auto share = solid_volumes(cell, cell_positions(block, cell));
    for (int i = 0; i < cell.count; ++i) volume[cell.node[i]] += share[i];
  }
  return volume;
}

}  // namespace voussoir
