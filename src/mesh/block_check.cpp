// Faults a block has by itself.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/check.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/border.hpp"
#include "mesh/lattice.hpp"
#include "mesh/mesh_check.hpp"

namespace voussoir {
namespace {

const double degree = std::acos(-1.0) / 180;

[[noreturn]] void refuse(const Block<2>& block, const std::string& fault, const std::string& why,
                         const std::string& advice) {
  throw InputError("mesh: " + block.name + fault + "\n  " + why + "\n  " + advice);
}

void check_nodes(const Block<2>& block) {
  VOUSSOIR_CHECK(block.vertex.size() == block.position.size());
  std::vector<char> used(block.position.size(), 0);
  for (const Cell& cell : block.cells)
    for (int k = 0; k < cell.count; ++k) {
      VOUSSOIR_CHECK(cell.node[k] >= 0 && cell.node[k] < static_cast<int>(used.size()));
      used[cell.node[k]] = 1;
    }
  for (std::size_t n = 0; n < used.size(); ++n) {
    const std::string node = ", node " + std::to_string(n) + " at " + place_in_words(block.position[n]);
    if (!std::isfinite(block.position[n][0]) || !std::isfinite(block.position[n][1]))
      refuse(block, node + " is nowhere", "(its coordinates must be finite numbers).",
             "Look for a division by zero or a missing number in the file.");
    if (!used[n])
      refuse(block, node + " belongs to no cell", "(it would have neither stiffness nor mass).",
             "Mesh the file again, or remove the node.");
  }
}

void check_shape(const Block<2>& block, std::size_t number) {
  const Cell& cell = block.cells[number];
  for (int k = 0; k < cell.count; ++k) {
    const auto corner = [&](int i) { return block.position[cell.node[(k + i) % cell.count]]; };
    const Vector<2> next = corner(1) - corner(0), previous = corner(cell.count - 1) - corner(0);
    const double jacobian = cross(next, previous), angle = std::atan2(jacobian, dot(next, previous)) / degree;
    const std::string where = ", cell " + std::to_string(number) + " with a corner at " + place_in_words(corner(0));
    if (norm(next) == 0 || norm(previous) == 0)
      refuse(block, where + " has two corners in one place", "(a side without length).",
             "Choose an element size in proportion to the block, or remove very short curves.");
    if (std::abs(angle) < smallest_corner_angle || std::abs(angle) > 180 - smallest_corner_angle)
      refuse(block, where + " is a sliver",
             "(the angle of that corner is " + in_words(std::abs(angle)) + " degrees; between " +
                 in_words(smallest_corner_angle) + " and " + in_words(180 - smallest_corner_angle) +
                 " can be computed).",
             "Choose an element size in proportion to the block, or remove very short curves.");
    if (jacobian < 0)
      refuse(block, where + " is inverted",
             "(its Jacobian is " + in_words(jacobian) +
                 " m2 there; nodes must turn counter-clockwise, corners point outward).",
             "Mesh the surface again with smaller elements or with triangles.");
  }
}

/// Every edge has one cell, or two on opposite sides, and all cells hang together over edges.
void check_pieces(const Block<2>& block) {
  struct Side {
    std::array<int, 2> node;  // ascending
    int cell;
    bool forward;  // the cell runs along the edge from the first node to the second
    bool operator<(const Side& o) const { return std::tie(node, cell) < std::tie(o.node, o.cell); }
  };
  std::vector<Side> sides;
  for (std::size_t c = 0; c < block.cells.size(); ++c)
    for (int k = 0; k < block.cells[c].count; ++k) {
      const int a = block.cells[c].node[k], b = block.cells[c].node[(k + 1) % block.cells[c].count];
      sides.push_back({{std::min(a, b), std::max(a, b)}, static_cast<int>(c), a < b});
    }
  std::sort(sides.begin(), sides.end());

  DisjointSets pieces(block.cells.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].node != sides[i + 1].node) continue;
    if (sides[i].forward == sides[i + 1].forward || (i + 2 < sides.size() && sides[i].node == sides[i + 2].node))
      refuse(block,
             ", the edge from " + place_in_words(block.position[sides[i].node[0]]) + " to " +
                 place_in_words(block.position[sides[i].node[1]]) + " has two cells on the same side",
             "(cells " + std::to_string(sides[i].cell) + " and " + std::to_string(sides[i + 1].cell) +
                 " there, or a third one, lie on each other).",
             "Remove doubled surfaces or elements and mesh again.");
    pieces.unite(sides[i].cell, sides[i + 1].cell);
  }
  for (std::size_t c = 0; c < pieces.size(); ++c)
    if (pieces.root(static_cast<int>(c)) != pieces.root(0))
      refuse(block,
             " is in pieces: cell 0 at " + place_in_words(block.position[block.cells[0].node[0]]) + " and cell " +
                 std::to_string(c) + " at " + place_in_words(block.position[block.cells[c].node[0]]) +
                 " are not connected over edges",
             "(a block is one elastic body; pieces would move freely against each other).",
             "Make each piece a surface of its own, in a .msh by an elementary number (the second tag of cells) of its "
             "own.");
}

}  // namespace

void check_block(const Block<2>& block) {
  if (block.cells.empty())
    refuse(block, " has no cells", "(a surface that was not meshed, or was not saved with the mesh).",
           "Mesh it; in a .msh file save all elements (Mesh.SaveAll = 1) or put it into a Physical Surface.");
  check_nodes(block);
  for (std::size_t c = 0; c < block.cells.size(); ++c) check_shape(block, c);
  check_pieces(block);
}

}  // namespace voussoir
