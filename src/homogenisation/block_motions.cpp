#include "homogenisation/block_motions.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "linalg/gather.hpp"
#include "linalg/local_view.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {

template <int dim>
BlockMotions<dim>::BlockMotions(const Structure<dim>& s, const ContactPoints<dim>& points,
                                const std::vector<char>& selected, const MergedSpace<dim>& space,
                                const std::vector<int>& active)
    : structure_(s), points_(points), space_(space), first_column_(active.size(), -1) {
  for (std::size_t b = 0; b < active.size(); ++b)
    if (active[b]) {
      first_column_[b] = size_;
      size_ += modes;
    }
  copies_.resize(space.clusters());
  for (int k : s.copy()) copies_[space.cluster()[k]].push_back(k);
  z_start_.push_back(0);
  std::vector<Row> couplings;
  for (int k = 0; k < space.owned_clusters(); ++k)
    for (int c = 0; c < dim; ++c) {
      const auto row = row_of(space.representative()[k], c);
      z_.insert(z_.end(), row.begin(), row.end());
      z_start_.push_back(z_.size());
    }
  for (int k = 0; k < points.owned(); ++k) {
    const auto& p = points.points()[k];
    if (!selected[k] || space.cluster()[p.node_i] == space.cluster()[p.node_j]) continue;
    jump_point_.push_back(k);
    for (int a = 0; a < dim; ++a) jump_.push_back(jump_row(p, a));
  }
  set_pattern(jump_);
  const auto append = [](std::vector<Place>& all, const std::vector<Place>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const auto& row : jump_) append(jump_place_, places(row));
  for (std::size_t i = 0; i + 1 < z_start_.size(); ++i)
    append(z_place_, places(Row(z_.begin() + static_cast<long>(z_start_[i]),
                                z_.begin() + static_cast<long>(z_start_[i + 1]))));
  add_elastic_energy();
}

template <int dim>
typename BlockMotions<dim>::Row BlockMotions<dim>::row_of(int node, int component) const {
  Row row;
  const int cluster = space_.cluster()[node];
  if (space_.held()[dim * cluster + component]) return row;
  const double share = 1.0 / static_cast<double>(copies_[cluster].size());
  for (int copy : copies_[cluster]) {
    const auto& block = structure_.blocks()[structure_.block_of_node()[copy]];
    const int first = first_column_[block.mesh.id];
    if (first < 0) continue;
    // Motions about the first node of the block, lengths relative to its first diagonal.
    const auto& origin = block.mesh.position.front();
    const double length = norm(block.mesh.position.back() - origin);
    const auto x = (1 / length) * (structure_.position()[copy] - origin);
    row.push_back({first + component, share});
    int rotation = first + dim;
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b, ++rotation) {
        if (component == a) row.push_back({rotation, -share * x[b]});
        if (component == b) row.push_back({rotation, share * x[a]});
      }
  }
  return row;
}

/// The gap of a point in one direction, as a combination of coarse unknowns.
template <int dim>
typename BlockMotions<dim>::Row BlockMotions<dim>::jump_row(const ContactPoint<dim>& p, int axis) const {
  Row jump;
  for (int c = 0; c < dim; ++c) {
    for (const auto& e : row_of(p.node_j, c)) jump.push_back({e.column, e.value * p.axis[axis][c]});
    for (const auto& e : row_of(p.node_i, c)) jump.push_back({e.column, -e.value * p.axis[axis][c]});
  }
  return jump;
}

/// Pairs of blocks that meet at a node of an owned block, at an unknown or across a point; all ranks get all of them.
template <int dim>
void BlockMotions<dim>::set_pattern(const std::vector<Row>& jumps) {
  std::set<std::pair<int, int>> mine;
  const auto couple = [&mine](std::set<int>& blocks) {
    for (int i : blocks)
      for (int j : blocks) mine.emplace(i, j);
    blocks.clear();
  };
  std::set<int> around;
  for (int b = 0; b < structure_.owned_blocks(); ++b) {
    const auto& block = structure_.blocks()[b];
    for (std::size_t i = 0; i < block.mesh.position.size(); ++i)
      for (const auto& e : row_of(block.first_local + static_cast<int>(i), 0)) around.insert(e.column / modes);
    for (std::size_t i = 0; i < block.mesh.position.size(); ++i)
      for (const auto& e : row_of(block.first_local + static_cast<int>(i), 1)) around.insert(e.column / modes);
    couple(around);
  }
  for (const auto& row : jumps) {
    for (const auto& e : row) around.insert(e.column / modes);
    couple(around);
  }
  for (std::size_t i = 0; i + 1 < z_start_.size(); ++i) {
    for (std::size_t k = z_start_[i]; k < z_start_[i + 1]; ++k) around.insert(z_[k].column / modes);
    couple(around);
  }
  for (int b = 0; b < size_ / modes; ++b) mine.emplace(b, b);
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [i, j] : mine) pairs.push_back({i, j});
  pairs = all_gather(pairs, *structure_.comm());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  for (auto first = pairs.begin(); first != pairs.end();) {
    auto last = first;
    while (last != pairs.end() && (*last)[0] == (*first)[0]) ++last;
    for (int m = 0; m < modes; ++m) {
      for (auto pair = first; pair != last; ++pair)
        for (int n = 0; n < modes; ++n) matrix_.column.push_back((*pair)[1] * modes + n);
      matrix_.start.push_back(matrix_.column.size());
    }
    first = last;
  }
  VOUSSOIR_ENSURE(matrix_.rows() == size_);
  VOUSSOIR_CHECK(matrix_.column.size() <= std::numeric_limits<Place>::max());
  matrix_.value.assign(matrix_.column.size(), 0.0);
}

/// Where row^T row stands in the matrix.
template <int dim>
std::vector<typename BlockMotions<dim>::Place> BlockMotions<dim>::places(const Row& row) const {
  std::vector<Place> place;
  for (const auto& i : row)
    for (const auto& j : row) {
      const auto first = matrix_.column.begin() + static_cast<long>(matrix_.start[i.column]);
      const auto last = matrix_.column.begin() + static_cast<long>(matrix_.start[i.column + 1]);
      place.push_back(static_cast<Place>(std::lower_bound(first, last, j.column) - matrix_.column.begin()));
    }
  return place;
}

template <int dim>
void BlockMotions<dim>::add_elastic_energy() {
  elastic_.assign(matrix_.value.size(), 0.0);
  std::vector<int> local(size_, -1);  // place of a coarse unknown among those of one block's surroundings
  for (int b = 0; b < structure_.owned_blocks(); ++b) {
    const auto& block = structure_.blocks()[b];
    const auto& k = block.stiffness;
    std::vector<Row> z(k.rows());
    std::vector<int> columns;
    for (int i = 0; i < k.rows(); ++i) {
      z[i] = row_of(block.first_local + i / dim, i % dim);
      for (auto& e : z[i]) {
        if (local[e.column] < 0) {
          local[e.column] = static_cast<int>(columns.size());
          columns.push_back(e.column);
        }
        e.column = local[e.column];
      }
    }
    // First K Z, then Z^T (K Z).
    const std::size_t n = columns.size();
    std::vector<double> kz(k.rows() * n, 0.0), product(n * n, 0.0);
    for (int i = 0; i < k.rows(); ++i)
      for (std::size_t e = k.start[i]; e < k.start[i + 1]; ++e)
        for (const auto& entry : z[k.column[e]]) kz[i * n + entry.column] += k.value[e] * entry.value;
    for (int i = 0; i < k.rows(); ++i)
      for (const auto& e : z[i])
        for (std::size_t j = 0; j < n; ++j) product[e.column * n + j] += e.value * kz[i * n + j];
    for (std::size_t i = 0; i < n; ++i) {
      const auto first = matrix_.column.begin() + static_cast<long>(matrix_.start[columns[i]]);
      const auto last = matrix_.column.begin() + static_cast<long>(matrix_.start[columns[i] + 1]);
      for (std::size_t j = 0; j < n; ++j)
        elastic_[std::lower_bound(first, last, columns[j]) - matrix_.column.begin()] += product[i * n + j];
    }
    for (int column : columns) local[column] = -1;
  }
}

template <int dim>
void BlockMotions<dim>::update(const std::vector<PointStiffness>& stiffness, const std::vector<double>& proximal) {
  auto mine = elastic_;
  // Adds factor row^T row at the next places; returns those after.
  const auto add_product = [&mine](const Entry* row, std::size_t size, double factor, const Place* place) {
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) mine[*place++] += factor * row[i].value * row[j].value;
    return place;
  };
  const Place* place = jump_place_.data();
  for (std::size_t k = 0; k < jump_point_.size(); ++k)
    for (int a = 0; a < dim; ++a) {
      const auto& point = stiffness[jump_point_[k]];
      const double sigma = a == 0 ? point.normal : point.tangential;
      const auto& row = jump_[k * dim + a];
      place = add_product(row.data(), row.size(), sigma, place);
    }
  place = z_place_.data();
  if (!proximal.empty())
    for (std::size_t i = 0; i + 1 < z_start_.size(); ++i)
      place = add_product(z_.data() + z_start_[i], z_start_[i + 1] - z_start_[i], proximal[i], place);
  Teuchos::reduceAll(*structure_.comm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(),
                     matrix_.value.data());
  if (factor_)
    factor_->refactor(matrix_);
  else
    factor_ = std::make_unique<SparseCholesky>(matrix_);
}

template <int dim>
void BlockMotions<dim>::add(const TpetraVector& r, TpetraVector& z) const {
  std::vector<double> mine(size_, 0.0), coarse(size_, 0.0);
  const double* fine = local_view(r);
  for (std::size_t i = 0; i + 1 < z_start_.size(); ++i)
    for (std::size_t k = z_start_[i]; k < z_start_[i + 1]; ++k) mine[z_[k].column] += z_[k].value * fine[i];
  {
    const TrafficScope sent_for(TrafficOf::block_motions);
    Teuchos::reduceAll(*structure_.comm(), Teuchos::REDUCE_SUM, size_, mine.data(), coarse.data());
  }
  factor_->solve(coarse.data(), coarse.data());
  double* value = local_view_to_write(z);
  for (std::size_t i = 0; i + 1 < z_start_.size(); ++i)
    for (std::size_t k = z_start_[i]; k < z_start_[i + 1]; ++k) value[i] += z_[k].value * coarse[z_[k].column];
}

template <int dim>
long long BlockMotions<dim>::bytes() const {
  std::size_t entries = z_.size();
  for (const auto& row : jump_) entries += row.size();
  return (factor_ ? factor_->bytes() : 0) + matrix_.bytes() +
         static_cast<long long>(entries * sizeof(Entry) + elastic_.size() * sizeof(double) +
                                (jump_place_.size() + z_place_.size()) * sizeof(Place));
}

template class BlockMotions<2>;

}  // namespace voussoir
