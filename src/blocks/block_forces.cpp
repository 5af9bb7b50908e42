#include "blocks/block_forces.hpp"

#include <algorithm>
#include <utility>

#include "blocks/condensed_edges.hpp"

namespace voussoir {

std::vector<double> handed_over(const BlockSystem& s, BlockForces forces) {
  for (int b = 0; s.edges() > 0 && b < s.local_blocks(); ++b) {
    const auto& block = s.nodes_of(b);
    if (!block.edges) continue;
    const auto of_edges = forces_of_edges(s, b, forces.of_edges);
    if (std::any_of(of_edges.begin(), of_edges.end(), [](double f) { return f != 0; }))
      block.edges->hand_over(of_edges, &forces.of_nodes[s.components() * static_cast<std::size_t>(block.first_local)]);
  }
  return std::move(forces.of_nodes);
}

std::vector<double> forces_of_edges(const BlockSystem& s, int block, const std::vector<double>& of_all) {
  const auto& b = s.nodes_of(block);
  if (!b.edges) return {};
  const auto count = static_cast<std::size_t>(s.components() * b.edges->size());
  if (of_all.empty()) return std::vector<double>(count, 0.0);
  const auto first = of_all.begin() + s.components() * static_cast<long>(b.first_edge);
  return {first, first + static_cast<long>(count)};
}

}  // namespace voussoir
