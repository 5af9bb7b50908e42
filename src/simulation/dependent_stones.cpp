#include "simulation/dependent_stones.hpp"

#include <algorithm>

namespace voussoir {

// Depth-first search from a root that holds all supported blocks (Hopcroft and Tarjan, Commun. ACM 16 (1973) 372-378):
// a block whose descendants reach no higher than its parent depends on the parent.
DependentStones::DependentStones(const BlockGraph& graph, const std::vector<int>& supported,
                                 const std::vector<int>& absent) {
  const int n = static_cast<int>(supported.size());
  const auto gone = [&](int b) { return !absent.empty() && absent[b] != 0; };
  constexpr int root = -1;
  std::vector<int> order(n, 0), low(n, 0), parent(n, root), next(n, 0);
  int count = 0;
  std::vector<BlockId> stack, visited;
  const auto enter = [&](BlockId b, int from) {
    order[b] = low[b] = ++count;
    if (supported[b]) low[b] = 0;  // the root was seen before all
    parent[b] = from;
    next[b] = graph.start[b];
    stack.push_back(b);
    visited.push_back(b);
  };
  for (BlockId first = 0; first < n; ++first) {
    if (!supported[first] || order[first] > 0 || gone(first)) continue;
    enter(first, root);
    while (!stack.empty()) {
      const BlockId b = stack.back();
      if (next[b] == graph.start[b + 1]) {
        stack.pop_back();
        if (parent[b] != root) low[parent[b]] = std::min(low[parent[b]], low[b]);
        continue;
      }
      const int k = next[b]++;
      const BlockId other = graph.neighbour[k];
      if (graph.shared_vertices[k] < 2 || gone(other) || other == parent[b]) continue;
      if (order[other] == 0)
        enter(other, b);
      else
        low[b] = std::min(low[b], order[other]);
    }
  }
  // In the order of visits a block comes before its descendants: what its parent depends on is known.
  for (const BlockId b : visited) {
    if (parent[b] == root) continue;
    if (low[b] >= order[parent[b]])
      on_[b] = parent[b];
    else if (const auto above = on_.find(parent[b]); above != on_.end())
      on_[b] = above->second;
  }
  for (const auto& [b, on] : on_) dependants_.push_back(b);
  for (auto it = visited.rbegin(); it != visited.rend(); ++it)
    if (on_.count(*it)) leaves_first_.push_back(*it);
}

std::map<BlockId, BlockSums> DependentStones::sums(std::vector<BlockSums> own) const {
  std::map<BlockId, BlockSums> of;  // of all dependants of a block
  for (const BlockId b : leaves_first_) {
    const auto at = std::lower_bound(dependants_.begin(), dependants_.end(), b) - dependants_.begin();
    auto whole = own[at];
    if (const auto below = of.find(b); below != of.end())
      for (int c = 0; c < 6; ++c) whole[c] += below->second[c];
    auto& sum = of[on_.at(b)];
    for (int c = 0; c < 6; ++c) sum[c] += whole[c];
  }
  return of;
}

}  // namespace voussoir
