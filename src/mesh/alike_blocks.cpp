#include "mesh/alike_blocks.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "mesh/translates.hpp"

namespace voussoir {
namespace {

/// Nodes of all cells, so many of each: of one with fewer its first one again.
std::vector<int> nodes_of_cells(const Block<3>& block, int width) {
  std::vector<int> nodes;
  for (const auto& cell : block.cells)
    for (int k = 0; k < width; ++k) nodes.push_back(cell.node[k < cell.count ? k : 0]);
  return nodes;
}

}  // namespace

void round_places(Block<3>& block, const DrawnNumbers& drawn) {
  const auto first = block.position.front();
  const auto base = drawn.rounded(first);
  for (auto& x : block.position) x = base + drawn.rounded(x - first);
}

void take_shape(const Block<3>& first, const std::vector<int>& order, const DrawnNumbers& drawn, Block<3>& block) {
  std::vector<int> number(order.size());
  std::vector<VertexId> vertex(order.size());
  const auto base = drawn.rounded(block.position[order.front()]);
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[order[k]] = static_cast<int>(k);
    vertex[k] = block.vertex[order[k]];
  }
  for (std::size_t k = 0; k < order.size(); ++k) block.position[k] = base + (first.position[k] - first.position[0]);
  block.vertex = std::move(vertex);
  block.cells = first.cells;
  for (auto& facet : block.facets)
    for (int& node : facet.node) node = number[node];
  for (int& node : block.folds) node = number[node];
  std::sort(block.folds.begin(), block.folds.end());
}

int make_alike_equal(std::vector<Block<3>>& blocks, double largest) {
  int width = 1;
  for (const auto& block : blocks)
    for (const auto& cell : block.cells) width = std::max(width, cell.count);
  const DrawnNumbers drawn(largest);
  Translates shapes(drawn.within());
  std::vector<std::size_t> first;  // of each shape
  std::vector<char> is_rounded;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    VOUSSOIR_EXPECT(blocks[b].curved.empty());
    if (blocks[b].cells.empty()) continue;
    const auto match = shapes.add(blocks[b].position, width, nodes_of_cells(blocks[b], width));
    if (match.is_first) {
      first.push_back(b);
      is_rounded.push_back(false);
      continue;
    }
    auto& model = blocks[first[match.shape]];
    if (!is_rounded[match.shape]) round_places(model, drawn);
    is_rounded[match.shape] = true;
    take_shape(model, match.order, drawn, blocks[b]);
  }
  return shapes.shapes();
}

}  // namespace voussoir
