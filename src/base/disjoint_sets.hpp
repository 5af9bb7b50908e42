// Sets that grow together: what is joined to what, over any number of steps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace voussoir {

/// Numbers 0 .. size-1, each a set of its own at first. A set is known by its root.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t size() const { return parent_.size(); }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Adds the set of one root to that of another, or of itself.
  void join(int root, int to) { parent_[root] = to; }
  /// Makes one set of those of two numbers; of their roots the smaller remains, and is returned.
  int unite(int i, int j) {
    const int a = root(i), b = root(j);
    join(std::max(a, b), std::min(a, b));
    return std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace voussoir
