// Walls in running bond.
//
// The lattice has blocks_per_course * cells_along columns and courses * cells_up rows.
// Even courses begin with a full block, odd ones with half a block.
#include <algorithm>
#include <limits>

#include "base/check.hpp"
#include "base/words.hpp"
#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"

namespace voussoir {
namespace {

enum WallSide { base, top, left, right };

class Wall final : public BlockSource<2> {
 public:
  explicit Wall(const WallParameters&);

  BlockId block_count() const override {
    return p_.openings.empty() ? number({p_.courses, 0}) : static_cast<BlockId>(place_.size());
  }
  int node_count(BlockId b) const override {
    const Extent e = extent(place(b));
    return (e.to - e.from + 1) * (p_.cells_up + 1);
  }
  Block<2> block(BlockId) const override;
  std::vector<Neighbour> neighbours(BlockId) const override;
  const SetNames& block_sets() const override { return block_sets_; }
  const std::vector<std::string>& facet_sets() const override { return facet_sets_; }

 private:
  struct Place {
    int course, stone;
  };
  /// Lattice columns a block begins and ends on.
  struct Extent {
    int from, to;
  };

  int stones(int course) const { return p_.blocks_per_course + course % 2; }
  /// Number of a place when no block is left out: two courses hold 2 n + 1 blocks.
  int number(Place p) const {
    return p.course / 2 * (2 * p_.blocks_per_course + 1) + p.course % 2 * p_.blocks_per_course + p.stone;
  }
  Place place(BlockId b) const {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    const int pair = 2 * p_.blocks_per_course + 1, at = p_.openings.empty() ? b : place_[b];
    const int rest = at % pair, odd = rest >= p_.blocks_per_course ? 1 : 0;
    return {at / pair * 2 + odd, rest - odd * p_.blocks_per_course};
  }
  Extent extent(Place p) const {
    const int columns = p_.blocks_per_course * p_.cells_along;
    const int shift = p.course % 2 * (p_.cells_along / 2);
    const int from = p.stone * p_.cells_along - shift;
    return {std::max(from, 0), std::min(from + p_.cells_along, columns)};
  }
  double x(int column) const { return p_.block_length * column / p_.cells_along; }
  double y(int row) const { return p_.block_height * row / p_.cells_up; }
  /// -1 for a block that is left out.
  BlockId block_at(Place p) const { return p_.openings.empty() ? number(p) : id_[number(p)]; }
  bool in_an_opening(Place) const;
  void add_neighbours(Place, int course, std::vector<Neighbour>&) const;

  WallParameters p_;
  // Where openings may leave blocks out; empty in a wall without.
  std::vector<int> place_;   ///< per block: its number when no block is left out
  std::vector<BlockId> id_;  ///< per such number: block, or -1 when left out
  SetNames block_sets_;
  std::vector<std::string> facet_sets_{"base", "top", "left", "right"};
};

void validate(const WallParameters& p) {
  require_at_least("wall > courses", p.courses, 1);
  require_at_least("wall > blocks per course", p.blocks_per_course, 1);
  require_positive("wall > block length", p.block_length, "m");
  require_positive("wall > block height", p.block_height, "m");
  require_at_least("wall > cells along", p.cells_along, 2);
  require_at_least("wall > cells up", p.cells_up, 1);
  if (p.cells_along % 2 != 0)
    refuse_mesh("wall > cells along", std::to_string(p.cells_along) + " [-]",
                "must be even (a half block has half of the cells, so that nodes of two courses meet).",
                "Give " + std::to_string(p.cells_along + 1) + ".");
  const double blocks = (p.blocks_per_course + 0.5) * p.courses;
  require_countable("wall > courses", p.courses, blocks,
                    std::max({p.blocks_per_course * double(p.cells_along), p.courses * double(p.cells_up),
                              (p.cells_along + 1.0) * (p.cells_up + 1.0)}));
  for (const auto& [name, o] : p.openings)
    if (!(o.x_from < o.x_to && o.y_from < o.y_to))
      refuse_mesh("wall > openings > " + name,
                  in_words(o.x_from) + " .. " + in_words(o.x_to) + " x " + in_words(o.y_from) + " .. " +
                      in_words(o.y_to) + " [m]",
                  "is empty: \"x to\" must exceed \"x from\" and \"y to\" must exceed \"y from\".",
                  "Give the corners of the opening, lower left first.");
}

Wall::Wall(const WallParameters& p) : p_(p) {
  validate(p_);
  for (int course = 0; course < p_.courses; ++course) block_sets_.push_back("course " + std::to_string(course));
  if (p_.openings.empty()) return;
  id_.assign(static_cast<std::size_t>(number({p_.courses, 0})), -1);
  for (int course = 0; course < p_.courses; ++course) {
    for (int stone = 0; stone < stones(course); ++stone) {
      if (in_an_opening({course, stone})) continue;
      id_[number({course, stone})] = static_cast<BlockId>(place_.size());
      place_.push_back(number({course, stone}));
    }
  }
  if (place_.empty())
    refuse_mesh("wall > openings", counted(p_.openings.size(), "opening"),
                "would leave no block of the wall: the centre of every block lies in an opening.",
                "Make the openings smaller than the wall, " + in_words(p_.blocks_per_course * p_.block_length) +
                    " m x " + in_words(p_.courses * p_.block_height) + " m.");
}

bool Wall::in_an_opening(Place p) const {
  const Extent e = extent(p);
  const double cx = (x(e.from) + x(e.to)) / 2, cy = (p.course + 0.5) * p_.block_height;
  return std::any_of(p_.openings.begin(), p_.openings.end(), [cx, cy](const auto& named) {
    const Opening& o = named.second;
    return o.x_from < cx && cx < o.x_to && o.y_from < cy && cy < o.y_to;
  });
}

Block<2> Wall::block(BlockId b) const {
  const Place p = place(b);
  const Extent e = extent(p);
  const int across = e.to - e.from, up = p_.cells_up, row0 = p.course * up;
  const int columns = p_.blocks_per_course * p_.cells_along, rows = p_.courses * up;
  Block<2> block;
  block.id = b;
  block.name = "block " + std::to_string(b) + " (course " + std::to_string(p.course) + ", stone " +
               std::to_string(p.stone) + ")";
  block.position.reserve(static_cast<std::size_t>(node_count(b)));
  block.vertex.reserve(block.position.capacity());
  for (int row = row0; row <= row0 + up; ++row)
    for (int column = e.from; column <= e.to; ++column) {
      block.position.push_back({x(column), y(row)});
      block.vertex.push_back(static_cast<VertexId>(row) * (columns + 1) + column);
    }
  block.cells = lattice_cells(across, up, p_.cells);
  block.sets = {p.course};
  if (row0 == 0) add_lattice_facets(block, across, up, LatticeSide::bottom, base);
  if (row0 + up == rows) add_lattice_facets(block, across, up, LatticeSide::top, top);
  if (e.from == 0) add_lattice_facets(block, across, up, LatticeSide::left, left);
  if (e.to == columns) add_lattice_facets(block, across, up, LatticeSide::right, right);
  return block;
}

/// Blocks of one course that share vertices with the block at a place, in ascending order.
void Wall::add_neighbours(Place p, int course, std::vector<Neighbour>& all) const {
  if (course < 0 || course >= p_.courses) return;
  const Extent mine = extent(p);
  // In courses of equal and of shifted bond no block reaches further than one place to either side.
  for (int stone = std::max(p.stone - 1, 0); stone <= std::min(p.stone + 1, stones(course) - 1); ++stone) {
    if (course == p.course && stone == p.stone) continue;
    const BlockId other = block_at({course, stone});
    const Extent its = extent({course, stone});
    const int columns = std::min(mine.to, its.to) - std::max(mine.from, its.from) + 1;
    if (other < 0 || columns < 1) continue;
    all.push_back({other, course == p.course ? p_.cells_up + 1 : columns});
  }
}

std::vector<Neighbour> Wall::neighbours(BlockId b) const {
  const Place p = place(b);
  std::vector<Neighbour> all;
  for (int course = p.course - 1; course <= p.course + 1; ++course) add_neighbours(p, course, all);
  return all;
}

}  // namespace

std::unique_ptr<BlockSource<2>> make_wall(const WallParameters& parameters) {
  return std::make_unique<Wall>(parameters);
}

}  // namespace voussoir
