// Walls of boxes in space, in running bond or with head joints above each other.
//
// The lattice has blocks_per_course * cells_along columns along x, cells_across rows along y and courses * cells_up
// storeys along z, below which the ground has one more.
#include <algorithm>
#include <limits>

#include "base/check.hpp"
#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

enum WallFacets { base, top, left, right, front, back, ground };

class WallInSpace final : public BlockSource<3> {
 public:
  explicit WallInSpace(const WallInSpaceParameters&);

  BlockId block_count() const override { return first_of(p_.courses); }
  int node_count(BlockId b) const override {
    const Box e = box(place(b));
    return (e.to - e.from + 1) * (p_.cells_across + 1) * (e.above - e.below + 1);
  }
  Block<3> block(BlockId) const override;
  const BlockGraph& graph() const override;
  const std::vector<std::string>& block_sets() const override { return block_sets_; }
  const std::vector<std::string>& facet_sets() const override { return facet_sets_; }

 private:
  /// A stone of a course, which is -1 for the ground.
  struct Place {
    int course, stone;
  };
  /// Columns and storeys that a block lies between.
  struct Box {
    int from, to, below, above;
  };

  bool has_ground() const { return p_.ground_height > 0; }
  int lowest() const { return has_ground() ? -1 : 0; }
  bool shifted(int course) const { return p_.bond == WallBond::running && course > 0 && course % 2 == 1; }
  int stones(int course) const { return p_.blocks_per_course + (shifted(course) ? 1 : 0); }
  /// Number of the first block of a course: of two courses in running bond one has a stone more.
  BlockId first_of(int course) const {
    const int more = p_.bond == WallBond::running ? std::max(course, 0) / 2 : 0;
    return (course - lowest()) * p_.blocks_per_course + more;
  }
  Place place(BlockId b) const {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    const int n = p_.blocks_per_course, below = has_ground() ? n : 0;
    if (b < below) return {-1, b};
    const int pair = 2 * n + (p_.bond == WallBond::running ? 1 : 0);
    const int rest = (b - below) % pair, odd = rest >= n ? 1 : 0;
    return {(b - below) / pair * 2 + odd, rest - odd * n};
  }
  Box box(Place p) const {
    const int columns = p_.blocks_per_course * p_.cells_along;
    const int from = p.stone * p_.cells_along - (shifted(p.course) ? p_.cells_along / 2 : 0);
    const int below = p.course < 0 ? -1 : p.course * p_.cells_up;
    return {std::max(from, 0), std::min(from + p_.cells_along, columns), below, p.course < 0 ? 0 : below + p_.cells_up};
  }
  Vector<3> position(int column, int row, int storey) const {
    return {p_.block_length * column / p_.cells_along, p_.thickness * row / p_.cells_across,
            storey < 0 ? -p_.ground_height : p_.block_height * storey / p_.cells_up};
  }
  void add_facets(Block<3>&, const Box&, Place) const;
  void add_neighbours(Place, int course, BlockGraph&) const;

  WallInSpaceParameters p_;
  std::vector<std::string> block_sets_;
  std::vector<std::string> facet_sets_{"base", "top", "left", "right", "front", "back"};
  mutable BlockGraph graph_;  ///< built when first asked for
};

void validate(const WallInSpaceParameters& p) {
  const std::string wall = "wall in space > ";
  require_at_least(wall + "courses", p.courses, 1);
  require_at_least(wall + "blocks per course", p.blocks_per_course, 1);
  require_positive(wall + "block length", p.block_length, "m");
  require_positive(wall + "block height", p.block_height, "m");
  require_positive(wall + "thickness", p.thickness, "m");
  require_at_least(wall + "cells along", p.cells_along, p.bond == WallBond::running ? 2 : 1);
  require_at_least(wall + "cells up", p.cells_up, 1);
  require_at_least(wall + "cells across", p.cells_across, 1);
  if (p.bond == WallBond::running && p.cells_along % 2 != 0)
    refuse_mesh(wall + "cells along", std::to_string(p.cells_along) + " [-]",
                "must be even in running bond (a half block has half of the cells, so that nodes of two courses meet).",
                "Give " + std::to_string(p.cells_along + 1) + ", or bond = stack.");
  if (p.ground_height != 0) require_positive(wall + "ground height", p.ground_height, "m");
  const double blocks = (p.blocks_per_course + 1.0) * (p.courses + 1.0);
  require_countable(wall + "courses", p.courses, blocks,
                    std::max({p.blocks_per_course * double(p.cells_along), p.courses * double(p.cells_up),
                              (p.cells_along + 1.0) * (p.cells_up + 1.0) * (p.cells_across + 1.0)}));
}

WallInSpace::WallInSpace(const WallInSpaceParameters& p) : p_(p) {
  validate(p_);
  for (int course = 0; course < p_.courses; ++course) block_sets_.push_back("course " + std::to_string(course));
  if (!has_ground()) return;
  block_sets_.push_back("ground");
  facet_sets_.push_back("ground");
}

Block<3> WallInSpace::block(BlockId b) const {
  const Place p = place(b);
  const Box e = box(p);
  const int columns = p_.blocks_per_course * p_.cells_along;
  Block<3> block;
  block.id = b;
  block.name = "block " + std::to_string(b) + (p.course < 0 ? " (ground" : " (course " + std::to_string(p.course)) +
               ", stone " + std::to_string(p.stone) + ")";
  block.position.reserve(static_cast<std::size_t>(node_count(b)));
  block.vertex.reserve(block.position.capacity());
  for (int storey = e.below; storey <= e.above; ++storey)
    for (int row = 0; row <= p_.cells_across; ++row)
      for (int column = e.from; column <= e.to; ++column) {
        block.position.push_back(position(column, row, storey));
        const VertexId line = static_cast<VertexId>(storey + 1) * (p_.cells_across + 1) + row;
        block.vertex.push_back(line * (columns + 1) + column);
      }
  block.cells = box_cells({e.to - e.from, p_.cells_across, e.above - e.below});
  block.sets = {p.course < 0 ? p_.courses : p.course};
  add_facets(block, e, p);
  return block;
}

/// The ground has its outer faces and the one below the wall in a set of its own: held there it stays where it is.
void WallInSpace::add_facets(Block<3>& block, const Box& e, Place p) const {
  const std::array<int, 3> cells{e.to - e.from, p_.cells_across, e.above - e.below};
  const bool is_ground = p.course < 0;
  const auto add = [&](int axis, bool far, int set) {
    add_box_facets(block, cells, axis, far, is_ground ? ground : set);
  };
  if (is_ground || p.course == 0) add(2, false, base);
  if (is_ground || p.course == p_.courses - 1) add(2, true, top);
  if (e.from == 0) add(0, false, left);
  if (e.to == p_.blocks_per_course * p_.cells_along) add(0, true, right);
  add(1, false, front);
  add(1, true, back);
}

/// Blocks of one course that share vertices with the block at a place, in ascending order.
void WallInSpace::add_neighbours(Place p, int course, BlockGraph& graph) const {
  if (course < lowest() || course >= p_.courses) return;
  const Box mine = box(p);
  const int rows = p_.cells_across + 1;
  // In courses of equal and of shifted bond no block reaches further than one place to either side.
  for (int stone = std::max(p.stone - 1, 0); stone <= std::min(p.stone + 1, stones(course) - 1); ++stone) {
    if (course == p.course && stone == p.stone) continue;
    const Box its = box({course, stone});
    const int columns = std::min(mine.to, its.to) - std::max(mine.from, its.from) + 1;
    if (columns < 1) continue;
    graph.neighbour.push_back(first_of(course) + stone);
    graph.shared_vertices.push_back(rows * (course == p.course ? mine.above - mine.below + 1 : columns));
  }
}

const BlockGraph& WallInSpace::graph() const {
  if (graph_.start.empty())
    graph_ = graph_of_blocks(block_count(), [&](BlockId b, BlockGraph& graph) {
      const Place p = place(b);
      for (int course = p.course - 1; course <= p.course + 1; ++course) add_neighbours(p, course, graph);
    });
  return graph_;
}

}  // namespace

std::unique_ptr<BlockSource<3>> make_wall_in_space(const WallInSpaceParameters& parameters) {
  return std::make_unique<WallInSpace>(parameters);
}

}  // namespace voussoir
