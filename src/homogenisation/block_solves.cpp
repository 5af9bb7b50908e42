#include "homogenisation/block_solves.hpp"

#include <algorithm>
#include <cmath>

#include "base/sort_unique.hpp"
#include "linalg/local_view.hpp"
#include "linalg/solver_failure.hpp"

namespace voussoir {

BlockSolves::BlockSolves(const BlockSystem& s, const MergedSpace& space, const std::vector<char>& active) {
  const int dim = space.components();
  std::vector<int> count(static_cast<std::size_t>(dim) * space.owned_clusters(), 0);
  block_start_.push_back(0);
  for (int b = 0; b < s.owned_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    if (!active[b]) continue;
    std::vector<int> rows;
    for (int i = 0; i < block.nodes; ++i) {
      const int k = space.cluster()[block.first_local + i];
      if (k >= space.owned_clusters()) continue;
      for (int c = 0; c < dim; ++c)
        if (!space.held()[dim * k + c]) rows.push_back(dim * k + c);
    }
    sort_unique(rows);
    for (int row : rows) ++count[row];
    unknown_.insert(unknown_.end(), rows.begin(), rows.end());
    block_start_.push_back(static_cast<int>(unknown_.size()));
  }
  for (int k : unknown_) weight_.push_back(1 / std::sqrt(static_cast<double>(count[k])));
  work_.resize(unknown_.size());
}

void BlockSolves::update(const OwnedRows& h) {
  LocalCsr blocks;  // upper triangles
  std::size_t both = unknown_.size();
  for (int row : unknown_) both += h.start[row + 1] - h.start[row];
  blocks.start.reserve(unknown_.size() + 1);
  blocks.column.reserve(both / 2);
  blocks.value.reserve(both / 2);
  for (std::size_t b = 0; b + 1 < block_start_.size(); ++b) {
    const auto first = unknown_.begin() + block_start_[b], last = unknown_.begin() + block_start_[b + 1];
    for (auto row = first; row != last; ++row) {
      auto next = row;
      const int* end = h.column + h.start[*row + 1];
      for (const int* column = std::lower_bound(h.column + h.start[*row], end, *row); column != end; ++column) {
        next = std::lower_bound(next, last, *column);
        if (next == last) break;
        if (*next != *column) continue;
        blocks.column.push_back(static_cast<int>(next - unknown_.begin()));
        blocks.value.push_back(h.value[column - h.column]);
      }
      blocks.start.push_back(static_cast<int>(blocks.column.size()));
    }
  }
  if (factor_)
    factor_->refactor(blocks);
  else
    factor_ = std::make_unique<SparseCholesky>(blocks);
}

void BlockSolves::add(const TpetraVector& r, TpetraVector& z, double factor) const {
  const double* right = local_view(r);
  for (std::size_t k = 0; k < unknown_.size(); ++k) work_[k] = weight_[k] * right[unknown_[k]];
  solve_or_not_a_number(work_, [&] { factor_->solve(work_.data(), work_.data()); });
  double* value = local_view_to_write(z);
  for (std::size_t k = 0; k < unknown_.size(); ++k) value[unknown_[k]] += factor * weight_[k] * work_[k];
}

long long BlockSolves::bytes() const {
  return (factor_ ? factor_->bytes() : 0) +
         static_cast<long long>(unknown_.size() * (sizeof(int) + sizeof(double)) + work_.size() * sizeof(double));
}

}  // namespace voussoir
