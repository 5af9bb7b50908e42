#include "base/half_spaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/dense.hpp"
#include "base/product.hpp"

namespace voussoir {
namespace {

using Column = std::vector<double>;

// [-] Half spaces are kept to this. It is far above round-off, or where many borders meet in one point round-off would
// choose more of them than there are directions, which looks as if they missed each other: in three million such points
// drawn by lot that happened once in 10^5 at 1e-14, once in 3 10^5 at 1e-12 and never at 1e-11.
constexpr double kept = 1e-11;
// [-] What is left of e where half spaces miss each other, which exact numbers would make nothing. Where they meet it
// is about 1 / |y|^2 for numbers of size one.
constexpr double nothing_left = 1e-11;

/// min |E u - e| over u >= 0, where e is the last unit vector and the columns of E are slopes with what is asked of y
/// below them. What is left of it, r, is -(y, 1) times the last number of r with its sign turned.
class NonNegative {
 public:
  explicit NonNegative(std::vector<Column> columns) : columns_(std::move(columns)), u_(columns_.size(), 0.0) {
    left_.assign(columns_.front().size(), 0.0);
    left_.back() = 1;
  }

  const Column& solve() {
    for (std::size_t most = 3 * columns_.size() + 3; most > 0; --most) {  // as the source does
      const int next = most_asked();
      if (next < 0) break;
      in_.push_back(next);
      if (move_to_the_best())
        refused_.clear();
      else
        refused_.push_back(next);
    }
    return left_;
  }

 private:
  /// The column that shortens what is left most; -1 where none does.
  int most_asked() const {
    int best = -1;
    double largest = 0;
    for (int j = 0; j < static_cast<int>(columns_.size()); ++j) {
      const auto has = [j](const std::vector<int>& list) {
        return std::find(list.begin(), list.end(), j) != list.end();
      };
      const double gain = product(columns_[j], left_);
      const bool is_any = gain > kept * std::sqrt(product(columns_[j], columns_[j]) * product(left_, left_));
      if (!is_any || gain <= largest || has(in_) || has(refused_)) continue;
      largest = gain;
      best = j;
    }
    return best;
  }

  /// Least squares of the columns taken, without those of negative shares; false where round-off alone chose the last.
  bool move_to_the_best() {
    while (true) {
      std::vector<Column> taken;
      for (const int j : in_) taken.push_back(columns_[j]);
      Column e(left_.size(), 0.0);
      e.back() = 1;
      const auto z = least_squares(taken, e);
      if (u_[in_.back()] == 0 && z.back() <= 0) {
        in_.pop_back();
        return false;
      }
      double share = 1;
      std::size_t first = in_.size();  // to reach zero
      for (std::size_t i = 0; i < in_.size(); ++i) {
        if (z[i] > 0) continue;
        const double of_this = u_[in_[i]] / (u_[in_[i]] - z[i]);
        if (first < in_.size() && of_this >= share) continue;
        share = of_this;
        first = i;
      }
      for (std::size_t i = 0; i < in_.size(); ++i) u_[in_[i]] += share * (z[i] - u_[in_[i]]);
      if (first == in_.size()) {
        left_ = std::move(e);
        take_off(taken, z);
        take_off(taken, least_squares(taken, left_));  // what round-off of large shares has left
        return true;
      }
      u_[in_[first]] = 0;
      in_.erase(in_.begin() + static_cast<std::ptrdiff_t>(first));
    }
  }

  void take_off(const std::vector<Column>& columns, const Column& shares) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      for (std::size_t c = 0; c < left_.size(); ++c) left_[c] -= shares[i] * columns[i][c];
  }

  std::vector<Column> columns_;
  Column u_, left_;
  std::vector<int> in_, refused_;
};

}  // namespace

std::vector<double> shortest_within(const std::vector<HalfSpace>& spaces, std::size_t size) {
  double scale = 0;  // of y, so that slopes and what is asked of them are of one size
  for (const auto& s : spaces) scale = std::max(scale, s.least);
  if (scale == 0) return std::vector<double>(size, 0.0);
  std::vector<Column> columns;
  for (const auto& s : spaces) {
    columns.push_back(s.slope);
    columns.back().push_back(s.least / scale);
  }
  const auto left = NonNegative(std::move(columns)).solve();
  if (left.back() <= nothing_left) return {};
  std::vector<double> y(size);
  for (std::size_t i = 0; i < size; ++i) y[i] = -scale * left[i] / left.back();
  return y;
}

}  // namespace voussoir
