#include "linalg/incomplete_cholesky.hpp"

#include <algorithm>
#include <utility>

namespace voussoir {
namespace {

/// Share of a diagonal entry below which the rest of it is no pivot: what is loose is shifted by 1e-10 of the largest.
constexpr double least_pivot = 1e-12;
/// First share of diagonal entries that is added to them where entries left out have made a pivot none; it doubles.
constexpr double first_shift = 0.01;
constexpr double largest_shift = 10;

}  // namespace

IncompleteCholesky::IncompleteCholesky(const TpetraMatrix& a) {
  const auto local = a.getLocalMatrixHost();
  const int rows = static_cast<int>(local.numRows());
  std::vector<std::pair<int, double>> row;
  for (int i = 0; i < rows; ++i) {
    const auto all = local.rowConst(i);
    row.clear();
    pivot_.push_back(0);
    for (int k = 0; k < all.length; ++k) {
      if (all.colidx(k) == i) pivot_.back() += all.value(k);
      if (all.colidx(k) > i && all.colidx(k) < rows) row.emplace_back(all.colidx(k), all.value(k));
    }
    std::sort(row.begin(), row.end());
    for (const auto& [j, value] : row) {
      column_.push_back(j);
      value_.push_back(value);
    }
    start_.push_back(static_cast<int>(column_.size()));
  }
  const auto diagonal = pivot_, value = value_;
  for (double shift = 0; !factor(diagonal) && shift < largest_shift;) {
    shift = std::max(first_shift, 2 * shift);
    value_ = value;
    pivot_ = diagonal;
    for (double& pivot : pivot_) pivot *= 1 + shift;
  }
}

/// Row by row: what a row has in common with those below it goes off them. Whether all pivots are some.
bool IncompleteCholesky::factor(const std::vector<double>& diagonal) {
  const int rows = static_cast<int>(pivot_.size());
  for (int k = 0; k < rows; ++k) {
    double& pivot = pivot_[k];
    if (!(pivot > least_pivot * diagonal[k])) return false;
    const int end = start_[k + 1];
    for (int e = start_[k]; e < end; ++e) {
      const int i = column_[e];
      const double factor = value_[e] / pivot;
      pivot_[i] -= factor * value_[e];
      int at = start_[i];
      for (int f = e + 1; f < end; ++f) {
        while (at < start_[i + 1] && column_[at] < column_[f]) ++at;
        if (at < start_[i + 1] && column_[at] == column_[f]) value_[at] -= factor * value_[f];
      }
    }
    for (int e = start_[k]; e < end; ++e) value_[e] /= pivot;
    pivot = 1 / pivot;
  }
  return true;
}

void IncompleteCholesky::solve(const double* r, double* z) const {
  const int rows = static_cast<int>(pivot_.size());
  if (z != r) std::copy_n(r, rows, z);
  for (int i = 0; i < rows; ++i)
    for (int e = start_[i]; e < start_[i + 1]; ++e) z[column_[e]] -= value_[e] * z[i];
  for (int i = rows - 1; i >= 0; --i) {
    double sum = z[i] * pivot_[i];
    for (int e = start_[i]; e < start_[i + 1]; ++e) sum -= value_[e] * z[column_[e]];
    z[i] = sum;
  }
}

long long IncompleteCholesky::bytes() const {
  return static_cast<long long>((start_.size() + column_.size()) * sizeof(int) +
                                (value_.size() + pivot_.size()) * sizeof(double));
}

}  // namespace voussoir
