#include "mesh/mesh.hpp"

namespace voussoir {

template <int dim>
BlockGraph graph_of(const BlockSource<dim>& source, BlockSpan span) {
  BlockGraph graph;
  graph.start.push_back(0);
  for (BlockId b = span.from; b < span.to; ++b) {
    for (const auto& [other, shared] : source.neighbours(b)) {
      graph.neighbour.push_back(other);
      graph.shared_vertices.push_back(shared);
    }
    graph.start.push_back(static_cast<int>(graph.neighbour.size()));
  }
  return graph;
}

template BlockGraph graph_of(const BlockSource<2>&, BlockSpan);
template BlockGraph graph_of(const BlockSource<3>&, BlockSpan);

}  // namespace voussoir
