#include "homogenisation/system_matrix.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

Teuchos::RCP<TpetraMatrix> distributed(const LocalCsr& a, const Teuchos::RCP<const TpetraMap>& rows,
                                       const Teuchos::RCP<const TpetraMap>& columns) {
  const Teuchos::ArrayRCP<std::size_t> start = Teuchos::arcp<std::size_t>(static_cast<long>(a.start.size()));
  const Teuchos::ArrayRCP<int> column = Teuchos::arcp<int>(static_cast<long>(a.column.size()));
  const Teuchos::ArrayRCP<double> value = Teuchos::arcp<double>(static_cast<long>(a.value.size()));
  std::copy(a.start.begin(), a.start.end(), start.begin());
  std::copy(a.column.begin(), a.column.end(), column.begin());
  std::copy(a.value.begin(), a.value.end(), value.begin());
  auto matrix = Teuchos::rcp(new TpetraMatrix(rows, columns, start, column, value));
  matrix->expertStaticFillComplete(rows, rows);
  return matrix;
}

}  // namespace

template <int dim>
SystemMatrix<dim>::SystemMatrix(const Structure<dim>& structure, const ContactPoints<dim>& points,
                                const std::vector<char>& selected, const MergedSpace<dim>& space)
    : structure_(structure), points_(points), selected_(selected), space_(space) {
  // Pattern by nodes: neighbours within a block, and across selected points.
  const auto& cluster = space.cluster();
  const int owned = space.owned_clusters();
  std::vector<std::vector<int>> neighbours(owned);
  for (const auto& b : structure.blocks())
    for (int i = 0; i < static_cast<int>(b.mesh.position.size()); ++i) {
      const int row = cluster[b.first_local + i];
      if (row >= owned) continue;
      const auto& k = b.stiffness;
      for (std::size_t e = k.start[dim * i]; e < k.start[dim * i + 1]; e += dim)
        neighbours[row].push_back(cluster[b.first_local + k.column[e] / dim]);
    }
  for (int k = 0; k < points.size(); ++k) {
    if (!selected[k]) continue;
    const int a = cluster[points.points()[k].node_i], b = cluster[points.points()[k].node_j];
    if (a < owned) neighbours[a].push_back(b);
    if (b < owned) neighbours[b].push_back(a);
  }
  for (auto& row : neighbours) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    for (int c = 0; c < dim; ++c) {
      for (int j : row)
        for (int d = 0; d < dim; ++d) local_.column.push_back(dim * j + d);
      local_.start.push_back(local_.column.size());
    }
  }
  local_.value.assign(local_.column.size(), 0.0);

  for (const auto& b : structure.blocks()) {
    const auto& k = b.stiffness;
    for (int i = 0; i < k.rows(); ++i) {
      const int row = dim * cluster[b.first_local + i / dim] + i % dim;
      if (row >= dim * owned) continue;
      for (std::size_t e = k.start[i]; e < k.start[i + 1]; ++e)
        entry(row, dim * cluster[b.first_local + k.column[e] / dim] + k.column[e] % dim) += k.value[e];
    }
  }
  diagonal_.resize(local_.rows());
  const auto& held = space.held();
  for (int i = 0; i < local_.rows(); ++i) {
    diagonal_[i] = static_cast<std::size_t>(&entry(i, i) - local_.value.data());
    for (std::size_t e = local_.start[i]; e < local_.start[i + 1]; ++e)
      if ((held[i] || held[local_.column[e]]) && e != diagonal_[i]) local_.value[e] = 0;
  }
  stiffness_values_ = local_.value;
  matrix_ = distributed(local_, space.map(), space.column_map());
}

template <int dim>
double& SystemMatrix<dim>::entry(int row, int column) {
  const auto first = local_.column.begin() + static_cast<long>(local_.start[row]);
  const auto last = local_.column.begin() + static_cast<long>(local_.start[row + 1]);
  const auto it = std::lower_bound(first, last, column);
  VOUSSOIR_ASSERT(it != last && *it == column);
  return local_.value[it - local_.column.begin()];
}

/// Adds w_ij (d_i, d_j) for the motion d of one node of a point against the other.
template <int dim>
template <class Weight>
void SystemMatrix<dim>::add_between(int k, const Weight& weight) {
  const auto& p = points_.points()[k];
  const std::array<int, 2> node{space_.cluster()[p.node_i], space_.cluster()[p.node_j]};
  if (node[0] == node[1]) return;  // tied by other points
  const auto& held = space_.held();
  for (int a = 0; a < 2; ++a) {
    if (node[a] >= space_.owned_clusters()) continue;
    for (int b = 0; b < 2; ++b)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          const int row = dim * node[a] + i, column = dim * node[b] + j;
          if (held[row] || held[column]) continue;
          const double value = weight(p.axis, i, j);
          entry(row, column) += a == b ? value : -value;
        }
  }
}

template <int dim>
void SystemMatrix<dim>::add_point(int k, const PointStiffness& stiffness) {
  add_between(k, [&](const auto& axis, int i, int j) {
    double value = stiffness.normal * axis[0][i] * axis[0][j];
    for (int t = 1; t < dim; ++t) value += stiffness.tangential * axis[t][i] * axis[t][j];
    return value;
  });
}

template <int dim>
bool SystemMatrix<dim>::couple(const std::vector<PointStiffness>& stiffness) {
  bool coupled = false;
  for (int k = 0; k < points_.size(); ++k) {
    const double c = stiffness[k].coupling;
    if (!selected_[k] || c == 0) continue;
    coupled = true;
    add_between(k, [c](const auto& axis, int i, int j) { return c * axis[1][i] * axis[0][j]; });
  }
  coupled = largest_over_ranks(*matrix_->getComm(), coupled) > 0;
  if (coupled) copy_values();
  return coupled;
}

template <int dim>
void SystemMatrix<dim>::copy_values() {
  auto values = matrix_->getLocalMatrixHost().values;
  std::copy(local_.value.begin(), local_.value.end(), values.data());
}

template <int dim>
void SystemMatrix<dim>::update(const std::vector<PointStiffness>& stiffness,
                               const std::vector<double>& proximal) {
  local_.value = stiffness_values_;
  for (int k = 0; k < points_.size(); ++k)
    if (selected_[k] && (stiffness[k].normal > 0 || stiffness[k].tangential > 0)) add_point(k, stiffness[k]);
  if (!proximal.empty())
    for (int i = 0; i < local_.rows(); ++i)
      if (!space_.held()[i]) local_.value[diagonal_[i]] += proximal[i];
  copy_values();
}

template class SystemMatrix<2>;

}  // namespace voussoir
