#include "mesh/lattice_in_space.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

std::vector<Box<3>> boxes_of(const std::vector<LatticeStone>& stones) {
  std::vector<Box<3>> boxes;
  boxes.reserve(stones.size());
  for (const auto& s : stones) {
    Box<3> box;
    for (int c = 0; c < 3; ++c) {
      box.low[c] = s.from[c];
      box.high[c] = s.to[c];
    }
    boxes.push_back(box);
  }
  return boxes;
}

class LatticeInSpace final : public BlockSource<3> {
 public:
  explicit LatticeInSpace(Masonry masonry) : m_(std::move(masonry)), tree_(boxes_of(m_.stones)) {}

  BlockId block_count() const override { return static_cast<BlockId>(m_.stones.size()); }
  int node_count(BlockId b) const override {
    const LatticeIndex n = cells(stone(b));
    return (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
  }
  Block<3> block(BlockId) const override;
  std::vector<Neighbour> neighbours(BlockId) const override;
  const SetNames& block_sets() const override { return m_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return m_.facet_sets; }

 private:
  const LatticeStone& stone(BlockId b) const {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    return m_.stones[static_cast<std::size_t>(b)];
  }
  static LatticeIndex cells(const LatticeStone& s) {
    return {s.to[0] - s.from[0], s.to[1] - s.from[1], s.to[2] - s.from[2]};
  }
  /// Corners along a direction that are not each other.
  int corners(int c) const { return m_.high[c] - m_.low[c] + (m_.closed && c == 1 ? 0 : 1); }
  VertexId vertex(const LatticeIndex& at) const {
    return (static_cast<VertexId>(at[2] - m_.low[2]) * corners(1) + (at[1] - m_.low[1])) * corners(0) +
           (at[0] - m_.low[0]);
  }
  /// Calls visit(b, s) for every other stone s that shares a corner with stone `b`, moved to where it touches it.
  template <class Visit>
  void visit_touching(BlockId b, Visit visit) const;
  void add_facets(Block<3>&, const LatticeStone&) const;

  Masonry m_;
  BoxTree<3> tree_;
};

template <class Visit>
void LatticeInSpace::visit_touching(BlockId b, Visit visit) const {
  const LatticeStone& mine = stone(b);
  const int round = corners(1);
  for (const int shift : m_.closed ? std::vector<int>{0, -round, round} : std::vector<int>{0}) {
    Box<3> box;
    for (int c = 0; c < 3; ++c) {
      box.low[c] = mine.from[c] + (c == 1 ? shift : 0);
      box.high[c] = mine.to[c] + (c == 1 ? shift : 0);
    }
    tree_.visit_overlaps(box, [&](int other) {
      if (other == b) return;
      LatticeStone moved = m_.stones[other];
      moved.from[1] -= shift;
      moved.to[1] -= shift;
      visit(other, moved);
    });
  }
}

Block<3> LatticeInSpace::block(BlockId b) const {
  const LatticeStone& s = stone(b);
  const StoneGroup& group = m_.groups[s.group];
  Block<3> block;
  block.id = b;
  block.name = "block " + std::to_string(b) + " (" + group.name + ", stone " + std::to_string(s.number) + ")";
  block.position.reserve(static_cast<std::size_t>(node_count(b)));
  block.vertex.reserve(block.position.capacity());
  for (int k = s.from[2]; k <= s.to[2]; ++k)
    for (int j = s.from[1]; j <= s.to[1]; ++j)
      for (int i = s.from[0]; i <= s.to[0]; ++i) {
        const bool beyond = m_.closed && j >= m_.high[1];
        const LatticeIndex at{i, beyond ? j - corners(1) : j, k};
        block.position.push_back(m_.place(at));
        block.vertex.push_back(vertex(at));
      }
  block.cells = box_cells(cells(s));
  block.sets = group.sets;
  add_facets(block, s);
  return block;
}

void LatticeInSpace::add_facets(Block<3>& block, const LatticeStone& s) const {
  std::vector<LatticeStone> touching;
  visit_touching(block.id, [&](int, const LatticeStone& other) { touching.push_back(other); });
  for (const auto& side : m_.sides) {
    const int axis = side.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int plane = side.far ? s.to[axis] : s.from[axis];
    if (m_.groups[s.group].part != side.part || (side.plane != MasonrySide::any && side.plane != plane)) continue;
    add_box_facets(block, cells(s), axis, side.far, side.set, [&](int i, int j) {
      const int at_u = s.from[u] + i, at_v = s.from[v] + j;
      return side.covered || std::none_of(touching.begin(), touching.end(), [&](const LatticeStone& o) {
               return (side.far ? o.from[axis] : o.to[axis]) == plane && o.from[u] <= at_u && at_u < o.to[u] &&
                      o.from[v] <= at_v && at_v < o.to[v];
             });
    });
  }
}

/// Two boxes share a box of corners; round a closed lattice they may share two.
std::vector<Neighbour> LatticeInSpace::neighbours(BlockId b) const {
  const LatticeStone& mine = stone(b);
  std::map<BlockId, int> shared;
  visit_touching(b, [&](BlockId other, const LatticeStone& its) {
    int corners = 1;
    for (int c = 0; c < 3; ++c) corners *= std::min(mine.to[c], its.to[c]) - std::max(mine.from[c], its.from[c]) + 1;
    shared[other] += corners;
  });
  std::vector<Neighbour> all;
  for (const auto& [other, corners] : shared) all.push_back({other, corners});
  return all;
}

}  // namespace

void add_ground_sides(Masonry& masonry, const std::string& name, int part) {
  const int set = static_cast<int>(masonry.facet_sets.size());
  masonry.facet_sets.push_back(name);
  for (const int axis : {2, 0, 1})
    for (const bool far : {false, true}) masonry.sides.push_back({set, axis, far, MasonrySide::any, axis == 2, part});
}

std::unique_ptr<BlockSource<3>> make_lattice_in_space(Masonry masonry) {
  return std::make_unique<LatticeInSpace>(std::move(masonry));
}

}  // namespace voussoir
