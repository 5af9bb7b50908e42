#include "blocks/condensed_edges.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {
namespace {

template <int dim>
Simplex<dim> simplex_of(const Block<dim>& block, const Cell& cell) {
  typename Simplex<dim>::Places x{};
  for (int i = 0; i < Simplex<dim>::corners; ++i) x[i] = block.position[cell.node[i]];
  return Simplex<dim>(x);
}

/// Rows of all components for each edge, columns of as many for each of what is beside it; values are 0.
/// @param upper  a row begins with its diagonal
LocalCsr pattern(std::vector<std::vector<int>>& beside, int components, bool upper) {
  LocalCsr k;
  for (std::size_t e = 0; e < beside.size(); ++e) {
    sort_unique(beside[e]);
    for (int c = 0; c < components; ++c) {
      const int row = components * static_cast<int>(e) + c;
      for (const int other : beside[e])
        for (int d = 0; d < components; ++d)
          if (!upper || components * other + d >= row) k.column.push_back(components * other + d);
      k.start.push_back(static_cast<int>(k.column.size()));
    }
  }
  k.value.assign(k.column.size(), 0.0);
  return k;
}

}  // namespace

template <int dim>
CondensedEdges::EdgeNumbers<dim> CondensedEdges::numbers_of(const Cell& cell) const {
  EdgeNumbers<dim> number;
  number.fill(-1);
  for (std::size_t e = 0; cell.count == Simplex<dim>::corners && e < number.size(); ++e) {
    const int a = cell.node[simplex_edges[e][0]], b = cell.node[simplex_edges[e][1]];
    const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge);
    if (at != edges_.end() && *at == edge) number[e] = static_cast<int>(at - edges_.begin());
  }
  return number;
}

template <int dim>
CondensedEdges::CondensedEdges(const Block<dim>& block, const Material& material, const ModelParameters& model)
    : edges_(block.curved), volume_(edges_.size(), 0.0) {
  VOUSSOIR_EXPECT(!edges_.empty());
  const auto elasticity = dim == 2 ? lame(material, model.plane) : lame(material);
  const double thickness = dim == 2 ? thickness_of(material, model) : 1.0;
  std::vector<std::vector<int>> corners(edges_.size()), others(edges_.size());
  for (const auto& cell : block.cells) {
    const auto number = numbers_of<dim>(cell);
    for (const int row : number) {
      if (row < 0) continue;
      corners[row].insert(corners[row].end(), cell.node.begin(), cell.node.begin() + Simplex<dim>::corners);
      std::copy_if(number.begin(), number.end(), std::back_inserter(others[row]), [&](int n) { return n >= row; });
    }
  }
  with_corners_ = pattern(corners, dim, false);
  auto with_edges = pattern(others, dim, true);
  for (const auto& cell : block.cells)
    if (const auto number = numbers_of<dim>(cell); *std::max_element(number.begin(), number.end()) >= 0)
      add_cell<dim>(cell, simplex_of(block, cell), number, elasticity, thickness, with_edges);
  factor_ = std::make_unique<SparseCholesky>(with_edges);
}

template <int dim>
void CondensedEdges::add_cell(const Cell& cell, const Simplex<dim>& simplex, const EdgeNumbers<dim>& number,
                              const Lame& elasticity, double thickness, LocalCsr& with_edges) {
  constexpr int edges = dim * Simplex<dim>::edges, corners = dim * Simplex<dim>::corners;
  const auto k = edge_stiffness(simplex, elasticity);
  for (int i = 0; i < edges; ++i) {
    if (number[i / dim] < 0) continue;
    const int row = dim * number[i / dim] + i % dim;
    for (int j = 0; j < corners; ++j)
      with_corners_.at(row, dim * cell.node[j / dim] + j % dim) += thickness * k.with_corners[corners * i + j];
    for (int j = 0; j < edges; ++j)
      if (const int column = dim * number[j / dim] + j % dim; column >= row)
        with_edges.at(row, column) += thickness * k.with_edges[edges * i + j];
    if (i % dim == 0) volume_[number[i / dim]] += thickness * edge_volume(simplex);
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

template <int dim>
void CondensedEdges::add_body_force(const Vector<dim>& force, double* of_edges) const {
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (int c = 0; c < dim; ++c) of_edges[dim * e + c] += volume_[e] * force[c];
}

void CondensedEdges::hand_over(std::vector<double> of_edges, double* of_corners) const {
  VOUSSOIR_EXPECT(static_cast<int>(of_edges.size()) == factor_->size() && "forces: of the edges of this block");
  factor_->solve(of_edges.data(), of_edges.data());
  for (int row = 0; row < with_corners_.rows(); ++row)
    for (int k = with_corners_.start[row]; k < with_corners_.start[row + 1]; ++k)
      of_corners[with_corners_.column[k]] -= with_corners_.value[k] * of_edges[row];
}

double CondensedEdges::energy(const std::vector<double>& of_edges) const {
  VOUSSOIR_EXPECT(static_cast<int>(of_edges.size()) == factor_->size() && "forces: of the edges of this block");
  std::vector<double> bend(of_edges.size());
  factor_->solve(of_edges.data(), bend.data());
  return std::inner_product(bend.begin(), bend.end(), of_edges.begin(), 0.0) / 2;
}

template <int dim>
std::vector<typename Simplex<dim>::OfEdges> CondensedEdges::bends(const Block<dim>& block, const std::vector<double>& u,
                                                                  std::vector<double> b) const {
  VOUSSOIR_EXPECT(static_cast<int>(b.size()) == factor_->size() && "forces: of the edges of this block");
  std::vector<double> of_corners(b.size());
  with_corners_.multiply(u.data(), of_corners.data());
  for (std::size_t i = 0; i < b.size(); ++i) b[i] -= of_corners[i];
  factor_->solve(b.data(), b.data());
  std::vector<typename Simplex<dim>::OfEdges> of_cells(block.cells.size());
  for (std::size_t n = 0; n < block.cells.size(); ++n) {
    of_cells[n] = {};
    const auto number = numbers_of<dim>(block.cells[n]);
    for (std::size_t e = 0; e < number.size(); ++e)
      for (int c = 0; number[e] >= 0 && c < dim; ++c) of_cells[n][e][c] = b[dim * number[e] + c];
  }
  return of_cells;
}

long long CondensedEdges::bytes() const {
  return factor_->bytes() + with_corners_.bytes() +
         static_cast<long long>(edges_.size() * sizeof(edges_[0]) + volume_.size() * sizeof(double));
}

template CondensedEdges::CondensedEdges(const Block<2>&, const Material&, const ModelParameters&);
template CondensedEdges::CondensedEdges(const Block<3>&, const Material&, const ModelParameters&);
template void CondensedEdges::add_body_force<2>(const Vector<2>&, double*) const;
template void CondensedEdges::add_body_force<3>(const Vector<3>&, double*) const;
template std::vector<Simplex<2>::OfEdges> CondensedEdges::bends(const Block<2>&, const std::vector<double>&,
                                                                std::vector<double>) const;
template std::vector<Simplex<3>::OfEdges> CondensedEdges::bends(const Block<3>&, const std::vector<double>&,
                                                                std::vector<double>) const;

}  // namespace voussoir
