#include "blocks/condensed_edges.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "blocks/assembly.hpp"
#include "blocks/tetrahedron.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {
namespace {

std::array<Vector<3>, 4> corners_of(const Block<3>& block, const Cell& cell) {
  return {block.position[cell.node[0]], block.position[cell.node[1]], block.position[cell.node[2]],
          block.position[cell.node[3]]};
}

/// Rows of three components for each edge, columns of three for each of what is beside it; values are 0.
/// @param upper  a row begins with its diagonal
LocalCsr pattern(std::vector<std::vector<int>>& beside, bool upper) {
  LocalCsr k;
  for (std::size_t e = 0; e < beside.size(); ++e) {
    sort_unique(beside[e]);
    for (int c = 0; c < 3; ++c) {
      const int row = 3 * static_cast<int>(e) + c;
      for (const int other : beside[e])
        for (int d = 0; d < 3; ++d)
          if (!upper || 3 * other + d >= row) k.column.push_back(3 * other + d);
      k.start.push_back(static_cast<int>(k.column.size()));
    }
  }
  k.value.assign(k.column.size(), 0.0);
  return k;
}

}  // namespace

CondensedEdges::EdgeNumbers CondensedEdges::numbers_of(const Cell& cell) const {
  EdgeNumbers number;
  number.fill(-1);
  for (std::size_t e = 0; cell.count == 4 && e < number.size(); ++e) {
    const int a = cell.node[tetrahedron_edges[e][0]], b = cell.node[tetrahedron_edges[e][1]];
    const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge);
    if (at != edges_.end() && *at == edge) number[e] = static_cast<int>(at - edges_.begin());
  }
  return number;
}

CondensedEdges::CondensedEdges(const Block<3>& block, const Material& material)
    : edges_(block.curved), volume_(edges_.size(), 0.0) {
  VOUSSOIR_EXPECT(!edges_.empty());
  std::vector<std::vector<int>> corners(edges_.size()), others(edges_.size());
  for (const auto& cell : block.cells) {
    const auto number = numbers_of(cell);
    for (const int row : number) {
      if (row < 0) continue;
      corners[row].insert(corners[row].end(), cell.node.begin(), cell.node.begin() + 4);
      std::copy_if(number.begin(), number.end(), std::back_inserter(others[row]), [&](int n) { return n >= row; });
    }
  }
  with_corners_ = pattern(corners, false);
  auto with_edges = pattern(others, true);
  for (const auto& cell : block.cells)
    if (const auto number = numbers_of(cell); *std::max_element(number.begin(), number.end()) >= 0)
      add_cell(cell, corners_of(block, cell), number, material, with_edges);
  factor_ = std::make_unique<SparseCholesky>(with_edges);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> force(3 * edges_.size(), 0.0);
    for (std::size_t e = 0; e < edges_.size(); ++e) force[3 * e + axis] = volume_[e];
    factor_->solve(force.data(), force.data());
    auto& handed = handed_over_[axis];
    handed.assign(3 * block.position.size(), 0.0);
    for (int row = 0; row < with_corners_.rows(); ++row)
      for (int k = with_corners_.start[row]; k < with_corners_.start[row + 1]; ++k)
        handed[with_corners_.column[k]] -= with_corners_.value[k] * force[row];
  }
}

void CondensedEdges::add_cell(const Cell& cell, const std::array<Vector<3>, 4>& x, const EdgeNumbers& number,
                              const Material& material, LocalCsr& with_edges) {
  const auto k = tetrahedron_edge_stiffness(x, material);
  for (int i = 0; i < 18; ++i) {
    if (number[i / 3] < 0) continue;
    const int row = 3 * number[i / 3] + i % 3;
    for (int j = 0; j < 12; ++j) with_corners_.at(row, 3 * cell.node[j / 3] + j % 3) += k.with_corners[12 * i + j];
    for (int j = 0; j < 18; ++j)
      if (const int column = 3 * number[j / 3] + j % 3; column >= row)
        with_edges.at(row, column) += k.with_edges[18 * i + j];
    if (i % 3 == 0) volume_[number[i / 3]] += tetrahedron_edge_volume(x);
  }
}

CondensedEdges::~CondensedEdges() = default;

LocalCsr CondensedEdges::stiffness(const LocalCsr& linear) const {
  const int n = linear.rows(), edges = factor_->size();
  std::vector<double> dense(static_cast<std::size_t>(n) * n, 0.0);
  for (int i = 0; i < n; ++i)
    for (int k = linear.start[i]; k < linear.start[i + 1]; ++k)
      dense[static_cast<std::size_t>(i) * n + linear.column[k]] = linear.value[k];
  // So many columns at a time, for which CHOLMOD passes over its factors once: more of them gain nothing.
  constexpr int portion = 48;
  std::vector<double> columns;
  for (int from = 0; from < n; from += portion) {
    const int to = std::min(n, from + portion);
    columns.assign(static_cast<std::size_t>(edges) * (to - from), 0.0);
    for (int row = 0; row < edges; ++row)
      for (int k = with_corners_.start[row]; k < with_corners_.start[row + 1]; ++k)
        if (const int c = with_corners_.column[k]; c >= from && c < to)
          columns[static_cast<std::size_t>(c - from) * edges + row] = with_corners_.value[k];
    factor_->solve(columns.data(), columns.data(), to - from);
    for (int c = from; c < to; ++c) {
      double* into = &dense[static_cast<std::size_t>(c) * n];
      const double* solved = &columns[static_cast<std::size_t>(c - from) * edges];
      for (int row = 0; row < edges; ++row)
        for (int k = with_corners_.start[row]; k < with_corners_.start[row + 1]; ++k)
          into[with_corners_.column[k]] -= with_corners_.value[k] * solved[row];
    }
  }
  LocalCsr result;
  result.column.reserve(dense.size());
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) result.column.push_back(j);
    result.start.push_back(static_cast<int>(result.column.size()));
    for (int j = 0; j < i; ++j) {  // symmetric to the last bit, as every other stiffness
      auto &low = dense[static_cast<std::size_t>(i) * n + j], &high = dense[static_cast<std::size_t>(j) * n + i];
      low = high = (low + high) / 2;
    }
  }
  result.value = std::move(dense);
  return result;
}

void CondensedEdges::hand_over(const Vector<3>& force, double* of_corners) const {
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; force[axis] != 0 && i < handed_over_[axis].size(); ++i)
      of_corners[i] += force[axis] * handed_over_[axis][i];
}

std::vector<std::array<Vector<3>, 6>> CondensedEdges::bends(const Block<3>& block, const std::vector<double>& u,
                                                            const Vector<3>& force) const {
  std::vector<double> b(3 * edges_.size());
  with_corners_.multiply(u.data(), b.data());
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (int c = 0; c < 3; ++c) b[3 * e + c] = volume_[e] * force[c] - b[3 * e + c];
  factor_->solve(b.data(), b.data());
  std::vector<std::array<Vector<3>, 6>> of_cells(block.cells.size());
  for (std::size_t n = 0; n < block.cells.size(); ++n) {
    of_cells[n] = {};
    const auto number = numbers_of(block.cells[n]);
    for (std::size_t e = 0; e < number.size(); ++e)
      for (int c = 0; number[e] >= 0 && c < 3; ++c) of_cells[n][e][c] = b[3 * number[e] + c];
  }
  return of_cells;
}

long long CondensedEdges::bytes() const {
  long long bytes = factor_->bytes() + with_corners_.bytes() +
                    static_cast<long long>(edges_.size() * sizeof(edges_[0]) + volume_.size() * sizeof(double));
  for (const auto& handed : handed_over_) bytes += static_cast<long long>(handed.size() * sizeof(double));
  return bytes;
}

}  // namespace voussoir
