// Which blocks meet, and the pattern of a matrix of their motions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/sort_unique.hpp"
#include "linalg/local_csr.hpp"

namespace voussoir {

/// Pairs of blocks, most of them met many times: doubles are dropped before they take more room than the pairs.
class PairsOfBlocks {
 public:
  using Pair = std::array<int, 2>;
  void add(int i, int j) {
    pairs_.push_back({i, j});
    if (pairs_.size() < full_) return;
    sort_unique(pairs_);
    full_ = std::max(full_, 2 * pairs_.size());
  }
  std::vector<Pair> all() && {
    sort_unique(pairs_);
    return std::move(pairs_);
  }

 private:
  std::vector<Pair> pairs_;
  std::size_t full_ = 1024;
};

/// The upper triangle of a matrix of blocks, all values 0.
/// @param pairs  of blocks that meet, each with itself too, in ascending order
inline LocalCsr pattern_of(const std::vector<PairsOfBlocks::Pair>& pairs, int modes) {
  LocalCsr matrix;
  std::size_t entries = 0;
  for (const auto& [i, j] : pairs) entries += i == j ? modes * (modes + 1) / 2 : modes * modes;
  matrix.column.reserve(entries);
  for (auto first = pairs.begin(); first != pairs.end();) {
    auto last = first;
    while (last != pairs.end() && (*last)[0] == (*first)[0]) ++last;
    for (int m = 0; m < modes; ++m) {
      for (auto pair = first; pair != last; ++pair)
        for (int n = pair == first ? m : 0; n < modes; ++n) matrix.column.push_back(modes * (*pair)[1] + n);
      matrix.start.push_back(static_cast<int>(matrix.column.size()));
    }
    first = last;
  }
  matrix.value.assign(matrix.column.size(), 0.0);
  return matrix;
}

}  // namespace voussoir
