#include "homogenisation/block_motions.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <map>

#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"

namespace voussoir {

template <int dim>
BlockMotions<dim>::BlockMotions(const Structure<dim>& s, const ContactPoints<dim>& points,
                                const std::vector<char>& selected, const MergedSpace<dim>& space,
                                const std::vector<int>& active)
    : structure_(s), points_(points), selected_(selected), space_(space), first_column_(active.size(), -1) {
  for (std::size_t b = 0; b < active.size(); ++b)
    if (active[b]) {
      first_column_[b] = size_;
      size_ += modes;
    }
  copies_.resize(space.clusters());
  for (int k : s.copy()) copies_[space.cluster()[k]].push_back(k);
  row_start_.push_back(0);
  for (int k = 0; k < space.owned_clusters(); ++k)
    for (int c = 0; c < dim; ++c) {
      const auto entries = entries_at(space.representative()[k], c);
      row_.insert(row_.end(), entries.begin(), entries.end());
      row_start_.push_back(row_.size());
    }
  assemble_elastic();
}

template <int dim>
std::vector<typename BlockMotions<dim>::Entry> BlockMotions<dim>::entries_at(int node, int component) const {
  std::vector<Entry> entries;
  const int cluster = space_.cluster()[node];
  if (space_.held()[dim * cluster + component]) return entries;
  const double share = 1.0 / static_cast<double>(copies_[cluster].size());
  for (int copy : copies_[cluster]) {
    const auto& block = structure_.blocks()[structure_.block_of_node()[copy]];
    const int first = first_column_[block.mesh.id];
    if (first < 0) continue;
    // Affine functions about the first node of the block, lengths relative to its first diagonal.
    const auto& origin = block.mesh.position.front();
    const double length = norm(block.mesh.position.back() - origin);
    const auto x = (1 / length) * (structure_.position()[copy] - origin);
    entries.push_back({first + component, share});
    for (int d = 0; d < dim; ++d) entries.push_back({first + dim * (1 + d) + component, share * x[d]});
  }
  return entries;
}

template <int dim>
void BlockMotions<dim>::add_product(const std::vector<Entry>& a, const std::vector<Entry>& b, double factor,
                                    std::vector<Triplet>& out) const {
  for (const auto& i : a)
    for (const auto& j : b) out.push_back({i.column, j.column, factor * i.value * j.value});
}

namespace {

template <class Triplet>
void compress(std::vector<Triplet>& t) {
  std::sort(t.begin(), t.end(),
            [](const Triplet& a, const Triplet& b) { return std::tie(a.row, a.column) < std::tie(b.row, b.column); });
  std::size_t last = 0;
  for (std::size_t k = 1; k < t.size(); ++k) {
    if (t[k].row == t[last].row && t[k].column == t[last].column)
      t[last].value += t[k].value;
    else
      t[++last] = t[k];
  }
  if (!t.empty()) t.resize(last + 1);
}

}  // namespace

template <int dim>
void BlockMotions<dim>::assemble_elastic() {
  for (int b = 0; b < structure_.owned_blocks(); ++b) {
    const auto& block = structure_.blocks()[b];
    const int rows = block.stiffness.rows();
    std::vector<std::vector<Entry>> z(rows);
    for (int i = 0; i < rows; ++i) z[i] = entries_at(block.first_local + i / dim, i % dim);
    // First K Z by columns of the few blocks around, then Z^T (K Z).
    std::map<int, int> column;
    for (const auto& row : z)
      for (const auto& e : row) column.emplace(e.column, 0);
    std::vector<int> names;
    for (auto& [name, index] : column) {
      index = static_cast<int>(names.size());
      names.push_back(name);
    }
    const std::size_t n = names.size();
    if (n == 0) continue;
    std::vector<double> kz(rows * n, 0.0), product(n * n, 0.0);
    for (int i = 0; i < rows; ++i)
      for (std::size_t k = block.stiffness.start[i]; k < block.stiffness.start[i + 1]; ++k)
        for (const auto& e : z[block.stiffness.column[k]])
          kz[i * n + column[e.column]] += block.stiffness.value[k] * e.value;
    for (int i = 0; i < rows; ++i)
      for (const auto& e : z[i]) {
        const std::size_t row = column[e.column] * n;
        for (std::size_t j = 0; j < n; ++j) product[row + j] += e.value * kz[i * n + j];
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) elastic_.push_back({names[i], names[j], product[i * n + j]});
  }
  compress(elastic_);
}

template <int dim>
LocalCsr BlockMotions<dim>::gathered(const std::vector<Triplet>& mine) const {
  auto all = all_gather(mine, *structure_.comm());
  compress(all);
  LocalCsr a;
  int row = 0;
  for (const auto& t : all) {
    while (row < t.row) {
      a.start.push_back(a.column.size());
      ++row;
    }
    a.column.push_back(t.column);
    a.value.push_back(t.value);
  }
  while (a.rows() < size_) a.start.push_back(a.column.size());
  return a;
}

template <int dim>
void BlockMotions<dim>::update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) {
  auto triplets = elastic_;
  for (int k = 0; k < points_.owned(); ++k) {
    if (!selected_[k]) continue;
    const auto& p = points_.points()[k];
    if (space_.cluster()[p.node_i] == space_.cluster()[p.node_j]) continue;
    for (int a = 0; a < dim; ++a) {
      const double sigma = a == 0 ? stiffness[k].normal : stiffness[k].tangential;
      std::vector<Entry> jump;
      for (int c = 0; c < dim; ++c) {
        for (const auto& e : entries_at(p.node_j, c)) jump.push_back({e.column, e.value * p.axis[a][c]});
        for (const auto& e : entries_at(p.node_i, c)) jump.push_back({e.column, -e.value * p.axis[a][c]});
      }
      add_product(jump, jump, sigma, triplets);  // also where sigma is 0: the pattern must not change
    }
  }
  for (std::size_t i = 0; i + 1 < row_start_.size(); ++i) {
    const std::vector<Entry> z(row_.begin() + static_cast<long>(row_start_[i]),
                               row_.begin() + static_cast<long>(row_start_[i + 1]));
    add_product(z, z, proximal.empty() ? 0.0 : proximal[i], triplets);
  }
  compress(triplets);
  const auto a = gathered(triplets);
  if (factor_)
    factor_->refactor(a);
  else
    factor_ = std::make_unique<SparseCholesky>(a);
}

template <int dim>
void BlockMotions<dim>::add(const TpetraVector& r, TpetraVector& z) const {
  std::vector<double> mine(size_, 0.0), coarse(size_, 0.0);
  const double* fine = local_view(r);
  for (std::size_t i = 0; i + 1 < row_start_.size(); ++i)
    for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k) mine[row_[k].column] += row_[k].value * fine[i];
  Teuchos::reduceAll(*structure_.comm(), Teuchos::REDUCE_SUM, size_, mine.data(), coarse.data());
  factor_->solve(coarse.data(), coarse.data());
  double* value = local_view_to_write(z);
  for (std::size_t i = 0; i + 1 < row_start_.size(); ++i)
    for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k) value[i] += row_[k].value * coarse[row_[k].column];
}

template class BlockMotions<2>;

}  // namespace voussoir
