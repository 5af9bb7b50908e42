#include "range/space/stiff_stones.hpp"

#include <algorithm>
#include <string>

#include "linalg/agree.hpp"
#include "linalg/reduce.hpp"
#include "mesh/curved_edges.hpp"
#include "mesh/facet_set.hpp"
#include "scene/scene.hpp"

namespace voussoir {
namespace {

double volume_of(const Block<3>& block, const Cell& cell) {
  const auto at = [&](int k) { return block.position[cell.node[k]] - block.position[cell.node[0]]; };
  return dot(at(3), cross(at(1), at(2))) / 6;
}

/// Whether the greater part of its volume is in cells whose corners are all on joints or supports. A bar with joints on
/// two sides bends by 0.45 of a beam where all of its cells lie so, by 0.83 where none does (src/stones/elements.md).
/// @param curved  edges that are not, ascending
bool is_mostly_between_joints(const Block<3>& block, const std::vector<std::array<int, 2>>& curved) {
  std::vector<char> on_joint(block.position.size(), 0);
  const auto each_edge = [&](const auto& visit) {
    for (const auto& cell : block.cells)
      for (int i = 0; i < cell.count; ++i)
        for (int j = 0; j < i; ++j) visit(std::min(cell.node[i], cell.node[j]), std::max(cell.node[i], cell.node[j]));
  };
  each_edge([&](int a, int b) {
    if (!std::binary_search(curved.begin(), curved.end(), std::array<int, 2>{a, b})) on_joint[a] = on_joint[b] = 1;
  });
  double inside = 0, between = 0;
  for (const auto& cell : block.cells) {
    const double volume = volume_of(block, cell);
    const bool between_joints =
        std::all_of(cell.node.begin(), cell.node.begin() + 4, [&](int n) { return on_joint[n] != 0; });
    (between_joints ? between : inside) += volume;
  }
  return between > inside;
}

}  // namespace

Warnings warnings_of_stiff_stones(const Scene& scene, const BlockSource<3>& source, const Teuchos::Comm<int>& comm) {
  const auto& stones = scene.mesh.stones;
  if (scene.mesh.type != MeshType::stones || stones.element != StoneElement::quadratic) return {};
  std::vector<FacetSet> supports;
  for (const auto& [name, support] : scene.supports)
    supports.push_back(facet_set(source, {support.on, support.blocks}));
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  long long found = 0;
  std::vector<std::string> first;
  for (BlockId b = read.from; b < read.to; ++b) {
    const auto block = source.block(b);
    if (block.cells.front().count != 4) continue;  // stones are of one kind of cells each
    const auto curved = curved_edges_off(block, [&](const TaggedFacet& facet) {
      return std::any_of(supports.begin(), supports.end(), [&](const auto& set) { return set.has(block, facet); });
    });
    if (!is_mostly_between_joints(block, curved)) continue;
    if (found++ == 0) first.push_back(block.name);
  }
  found = total_over_ranks(comm, found);
  first = first_texts(comm, first, 1);
  if (found == 0) return {};
  return {{"one_cell_between_joints", scene.file + ": scene > mesh > stones > element size", "",
           static_cast<double>(found),
           first.front() + (found == 1 ? " has" : " and " + std::to_string(found - 1) + " more have") +
               " joints or supports all round and one cell between them in most of " + (found == 1 ? "its" : "their") +
               " volume: such stones bend by half and less of what they should, which displacements and the spread of "
               "forces over joints show; take cells of half the thinnest of them"}};
}

}  // namespace voussoir
