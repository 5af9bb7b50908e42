#include "ties/dependence.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"

namespace voussoir {
namespace {

using Graph = std::vector<std::vector<int>>;  // numbers of what each touches

/// Depth-first search with the earliest that each and what was seen after it touch (Hopcroft and Tarjan, Commun. ACM 16
/// (1973) 372-378). Leave(v, parent, cut_off) is called when all behind v has been seen.
class Search {
 public:
  explicit Search(const Graph& graph)
      : graph_(graph),
        order_(graph.size(), 0),
        low_(graph.size(), 0),
        parent_(graph.size(), -1),
        next_(graph.size(), 0) {}

  template <class Enter, class Leave>
  void from(int first, const Enter& enter, const Leave& leave) {
    if (seen(first)) return;
    visit(first, -1, enter);
    while (!stack_.empty()) {
      const int v = stack_.back();
      if (next_[v] < graph_[v].size()) {
        const int other = graph_[v][next_[v]++];
        if (other == parent_[v]) continue;
        if (!seen(other))
          visit(other, v, enter);
        else
          low_[v] = std::min(low_[v], order_[other]);
        continue;
      }
      stack_.pop_back();
      const int parent = parent_[v];
      if (parent < 0) continue;
      low_[parent] = std::min(low_[parent], low_[v]);
      leave(v, parent, low_[v] >= order_[parent]);
    }
  }
  bool seen(int v) const { return order_[v] > 0; }

 private:
  template <class Enter>
  void visit(int v, int parent, const Enter& enter) {
    order_[v] = low_[v] = ++count_;
    parent_[v] = parent;
    stack_.push_back(v);
    enter(v);
  }

  const Graph& graph_;
  int count_ = 0;
  std::vector<int> order_, low_, parent_;
  std::vector<std::size_t> next_;
  std::vector<int> stack_;
};

void join(Graph& graph, int a, int b) {
  graph[a].push_back(b);
  graph[b].push_back(a);
}

}  // namespace

HeldStones::HeldStones(const std::vector<HoldEachOther>& pairs) {
  stone_.push_back(the_ground);
  for (const auto& pair : pairs) stone_.insert(stone_.end(), {pair.a, pair.b});
  sort_unique(stone_);
  Graph graph(stone_.size());
  for (const auto& pair : pairs) join(graph, place(pair.a), place(pair.b));
  for (auto& beside : graph) sort_unique(beside);
  std::vector<int> cut_off_by(stone_.size(), -1), seen, parent(stone_.size(), -1);
  Search search(graph);
  search.from(
      0, [&](int v) { seen.push_back(v); },
      [&](int v, int p, bool cut_off) {
        parent[v] = p;
        if (cut_off) cut_off_by[v] = p;
      });
  held_.assign(stone_.size(), 0);
  on_.assign(stone_.size(), the_ground);
  for (const int v : seen) {  // parents before those that were seen after them
    held_[v] = 1;
    if (parent[v] <= 0) continue;
    on_[v] = cut_off_by[v] > 0 ? stone_[cut_off_by[v]] : on_[parent[v]];
  }
}

int HeldStones::place(BlockId b) const {
  const auto at = std::lower_bound(stone_.begin(), stone_.end(), b);
  return at != stone_.end() && *at == b ? static_cast<int>(at - stone_.begin()) : -1;
}

bool HeldStones::holds(BlockId b) const {
  const int at = place(b);
  return at >= 0 && held_[at] != 0;
}

BlockId HeldStones::depends_on(BlockId b) const {
  const int at = place(b);
  return at >= 0 ? on_[at] : the_ground;
}

OwnStones::OwnStones(std::vector<BlockId> stones, const std::vector<HoldEachOther>& pairs,
                     const std::vector<HoldEachOther>& across)
    : stone_(std::move(stones)) {
  stone_.insert(stone_.begin(), the_ground);
  VOUSSOIR_EXPECT(std::is_sorted(stone_.begin(), stone_.end()) && "stones: ascending");
  const auto number = [&](BlockId b) {
    return static_cast<int>(std::lower_bound(stone_.begin(), stone_.end(), b) - stone_.begin());
  };
  const auto is_own = [&](BlockId b) { return std::binary_search(stone_.begin(), stone_.end(), b); };
  Graph beside(stone_.size());
  for (const auto& pair : pairs) join(beside, number(pair.a), number(pair.b));
  for (auto& of_stone : beside) sort_unique(of_stone);
  std::vector<char> border(stone_.size(), 0);
  border[0] = 1;
  for (const auto& pair : across) {
    border[number(is_own(pair.a) ? pair.a : pair.b)] = 1;
    at_borders_.push_back(pair);
  }
  find_parts(beside);
  strip_hanging(border);
  for (const auto& part : between_) {
    const auto& ring = part.meets_others;
    for (std::size_t k = ring.size() == 2 ? 1 : 0; k < ring.size(); ++k)
      at_borders_.push_back({stone_[ring[k]], stone_[ring[(k + 1) % ring.size()]]});
  }
}

void OwnStones::find_parts(const Graph& beside) {
  Search search(beside);
  std::vector<int> open;  // seen and of no part yet
  for (int first = 0; first < static_cast<int>(beside.size()); ++first)
    search.from(
        first, [&](int v) { open.push_back(v); },
        [&](int v, int parent, bool cut_off) {
          if (!cut_off) return;
          Part part;
          do {
            part.members.push_back(open.back());
            open.pop_back();
          } while (part.members.back() != v);
          part.members.push_back(parent);
          between_.push_back(std::move(part));
        });
}

/// Of the members of a part those that others touch: stones at a border, and in other parts that are left.
std::vector<int> OwnStones::touched(const Part& part, const std::vector<char>& border, const std::vector<int>& left) {
  std::vector<int> places;
  for (const int v : part.members)
    if (border[v] || left[v] > 1) places.push_back(v);
  return places;
}

/// Takes away parts that meet what is left in one stone or none, until none does.
void OwnStones::strip_hanging(const std::vector<char>& border) {
  std::vector<std::vector<int>> parts_of(stone_.size());
  for (std::size_t n = 0; n < between_.size(); ++n)
    for (const int v : between_[n].members) parts_of[v].push_back(static_cast<int>(n));
  std::vector<int> left;  // parts that a stone is still in
  for (const auto& parts : parts_of) left.push_back(static_cast<int>(parts.size()));
  std::vector<char> taken(between_.size(), 0);
  std::vector<int> to_look_at(between_.size());
  std::iota(to_look_at.rbegin(), to_look_at.rend(), 0);
  while (!to_look_at.empty()) {
    const int n = to_look_at.back();
    to_look_at.pop_back();
    auto& part = between_[n];
    part.meets_others = touched(part, border, left);
    if (taken[n] || part.meets_others.size() > 1) continue;
    taken[n] = 1;
    hanging_.push_back(part);
    for (const int v : part.members)
      if (--left[v] == 1) to_look_at.insert(to_look_at.end(), parts_of[v].begin(), parts_of[v].end());
  }
  std::vector<Part> kept;
  for (std::size_t n = 0; n < between_.size(); ++n)
    if (!taken[n]) kept.push_back({between_[n].members, touched(between_[n], border, left)});
  between_ = std::move(kept);
}

/// What all of a part depend on, but for that stone itself, if it is one of them.
BlockId OwnStones::hangs_on(const Part& part, const std::vector<BlockId>& on) const {
  const int a = part.meets_others[0], b = part.meets_others[1];
  if (a > 0 && on[b] == stone_[a]) return stone_[a];
  if (b > 0 && on[a] == stone_[b]) return stone_[b];
  return a > 0 ? on[a] : on[b];
}

std::vector<Dependence> OwnStones::dependences(const HeldStones& known) const {
  std::vector<char> held(stone_.size(), 0), known_to_others(stone_.size(), 0);
  std::vector<BlockId> on(stone_.size(), the_ground);
  for (std::size_t v = 0; v < stone_.size(); ++v) {
    held[v] = known.holds(stone_[v]);
    on[v] = known.depends_on(stone_[v]);
  }
  held[0] = 1;
  for (const auto& part : between_)
    for (const int v : part.meets_others) known_to_others[v] = 1;
  for (const auto& part : between_) {
    const BlockId of_all = hangs_on(part, on);
    for (const int v : part.members)
      if (!known_to_others[v]) held[v] = held[part.meets_others[0]], on[v] = of_all;
  }
  for (auto part = hanging_.rbegin(); part != hanging_.rend(); ++part) {
    if (part->meets_others.empty()) continue;  // nothing holds it
    const int from = part->meets_others.front();
    for (const int v : part->members)
      if (v != from) held[v] = held[from], on[v] = stone_[from];
  }
  std::vector<Dependence> found;
  for (std::size_t v = 1; v < stone_.size(); ++v)
    if (held[v] && on[v] != the_ground) found.push_back({stone_[v], on[v]});
  return found;
}

}  // namespace voussoir
