// A stack of equal boxes.
#include <algorithm>

#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"
#include "mesh/lattice_in_space.hpp"

namespace voussoir {
namespace {

void validate(const PrismParameters& p) {
  require_positive("prism > length", p.length, "m");
  require_positive("prism > width", p.width, "m");
  require_positive("prism > height", p.height, "m");
  require_at_least("prism > stones", p.stones, 1);
  require_at_least("prism > cells along", p.cells_along, 1);
  require_at_least("prism > cells across", p.cells_across, 1);
  require_at_least("prism > cells up", p.cells_up, 1);
  if (p.ground_height != 0) require_positive("prism > ground height", p.ground_height, "m");
  const double corners = (p.cells_along + 1.0) * (p.cells_across + 1.0) * (p.cells_up + 1.0);
  require_countable("prism > stones", p.stones, p.stones + 1.0, std::max(corners, p.stones * double(p.cells_up)));
}

}  // namespace

std::unique_ptr<BlockSource<3>> make_prism(const PrismParameters& p) {
  validate(p);
  const LatticeIndex cells{p.cells_along, p.cells_across, p.cells_up};
  Masonry m;
  m.low = {0, 0, -1};
  m.high = {cells[0], cells[1], p.stones * cells[2]};
  m.facet_sets = {"base", "top", "left", "right", "front", "back"};
  m.sides = {{0, 2, false, 0, true}, {1, 2, true, m.high[2]}, {2, 0, false}, {3, 0, true}, {4, 1, false}, {5, 1, true}};
  if (p.ground_height > 0) {
    m.groups.push_back({"ground", {p.stones}, ground_part});
    m.stones.push_back({{0, 0, -1}, {cells[0], cells[1], 0}, 0, 0});
    add_ground_sides(m, "ground", ground_part);
  }
  for (int stone = 0; stone < p.stones; ++stone) {
    const std::string name = "course " + std::to_string(stone);
    m.block_sets.push_back(name);
    m.stones.push_back(
        {{0, 0, stone * cells[2]}, {cells[0], cells[1], (stone + 1) * cells[2]}, static_cast<int>(m.groups.size()), 0});
    m.groups.push_back({name, {stone}, 0});
  }
  if (p.ground_height > 0) m.block_sets.push_back("ground");
  m.place = [p](const LatticeIndex& at) {
    return Vector<3>{p.length * at[0] / p.cells_along, p.width * at[1] / p.cells_across,
                     at[2] < 0 ? -p.ground_height : p.height * at[2] / (p.stones * p.cells_up)};
  };
  return make_lattice_in_space(std::move(m));
}

}  // namespace voussoir
