#include "ties/dependent_stones.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace voussoir {

namespace {

/// Depth-first search from a root that holds all supported blocks (Hopcroft and Tarjan, Commun. ACM 16 (1973) 372-378).
class Search {
 public:
  static constexpr int root = -1;

  Search(const BlockGraph& graph, const std::vector<int>& supported, const std::vector<int>& absent, int of_facet)
      : graph_(graph),
        supported_(supported),
        absent_(absent),
        of_facet_(of_facet),
        order_(supported.size(), 0),
        low_(supported.size(), 0),
        parent_(supported.size(), root),
        next_(supported.size(), 0) {
    for (BlockId first = 0; first < static_cast<int>(supported.size()); ++first)
      if (supported[first] && is_new(first)) visit_from(first);
  }

  /// In the order of visits a block comes before its descendants.
  const std::vector<BlockId>& visited() const { return visited_; }
  BlockId parent(BlockId b) const { return parent_[b]; }
  /// The descendants of a block, itself included, reach no higher than its parent.
  bool cut_off_by_parent(BlockId b) const { return low_[b] >= order_[parent_[b]]; }

 private:
  bool is_new(BlockId b) const { return order_[b] == 0 && (absent_.empty() || absent_[b] == 0); }

  void enter(BlockId b, int from) {
    order_[b] = low_[b] = static_cast<int>(visited_.size()) + 1;
    if (supported_[b]) low_[b] = 0;  // the root was seen before all
    parent_[b] = from;
    next_[b] = graph_.start[b];
    stack_.push_back(b);
    visited_.push_back(b);
  }

  void leave(BlockId b) {
    stack_.pop_back();
    if (parent_[b] != root) low_[parent_[b]] = std::min(low_[parent_[b]], low_[b]);
  }

  /// Blocks that share no facet hold nothing of each other.
  void look_along(BlockId b, int k) {
    const BlockId other = graph_.neighbour[k];
    if (graph_.shared_vertices[k] < of_facet_ || other == parent_[b]) return;
    if (is_new(other))
      enter(other, b);
    else if (order_[other] > 0)
      low_[b] = std::min(low_[b], order_[other]);
  }

  void visit_from(BlockId first) {
    enter(first, root);
    while (!stack_.empty()) {
      const BlockId b = stack_.back();
      if (next_[b] == graph_.start[b + 1])
        leave(b);
      else
        look_along(b, next_[b]++);
    }
  }

  const BlockGraph& graph_;
  const std::vector<int>&supported_, &absent_;
  const int of_facet_;
  std::vector<int> order_, low_, parent_, next_;
  std::vector<BlockId> stack_, visited_;
};

}  // namespace

// A block whose descendants reach no higher than its parent depends on the parent.
DependentStones::DependentStones(const BlockGraph& graph, const std::vector<int>& supported,
                                 const std::vector<int>& absent, int of_facet) {
  VOUSSOIR_EXPECT(graph.start.size() == supported.size() + 1 && "supported: per block of the structure");
  VOUSSOIR_EXPECT((absent.empty() || absent.size() == supported.size()) && "absent: per block, or none");
  const Search search(graph, supported, absent, of_facet);
  for (const BlockId b : search.visited()) {
    const BlockId parent = search.parent(b);
    if (parent == Search::root) continue;
    if (search.cut_off_by_parent(b))
      on_[b] = parent;
    else if (const auto above = on_.find(parent); above != on_.end())
      on_[b] = above->second;
  }
  for (const auto& [b, on] : on_) dependants_.push_back(b);
  const auto& visited = search.visited();
  for (auto it = visited.rbegin(); it != visited.rend(); ++it)
    if (on_.count(*it)) leaves_first_.push_back(*it);
}

std::map<BlockId, BlockSums> DependentStones::sums(std::vector<BlockSums> own) const {
  VOUSSOIR_EXPECT(own.size() == dependants_.size() && "sums: of each that depends on another");
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
