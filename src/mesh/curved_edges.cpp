#include "mesh/curved_edges.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/sort_unique.hpp"
#include "mesh/border.hpp"

namespace voussoir {
namespace {

using Edge = std::array<int, 2>;

Edge edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// All pairs of nodes of the cells with so many of them: of triangles and tetrahedra their edges; of quadrilaterals and
/// hexahedra diagonals too, which a tetrahedron beside may have as its edge.
template <int dim>
std::vector<Edge> pairs_of(const Block<dim>& block, int count) {
  std::vector<Edge> pairs;
  for (const auto& cell : block.cells) {
    if (cell.count != count) continue;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < i; ++j) pairs.push_back(edge(cell.node[i], cell.node[j]));
  }
  sort_unique(pairs);
  return pairs;
}

std::vector<Edge> without(const std::vector<Edge>& all, const std::vector<Edge>& some) {
  std::vector<Edge> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

/// An edge of a block by its vertices, so that blocks that touch have the same.
struct PlacedEdge {
  std::array<VertexId, 2> vertices;
  BlockId block;  ///< its place in the list
  Edge nodes;
  bool operator<(const PlacedEdge& other) const {
    return std::tie(vertices, block, nodes) < std::tie(other.vertices, other.block, other.nodes);
  }
};

/// The vertices that two blocks or more have, ascending.
template <int dim>
std::vector<VertexId> shared_vertices(const std::vector<Block<dim>>& blocks) {
  std::vector<VertexId> all, shared;
  for (const auto& block : blocks) all.insert(all.end(), block.vertex.begin(), block.vertex.end());
  std::sort(all.begin(), all.end());
  for (std::size_t k = 1; k < all.size(); ++k)
    if (all[k] == all[k - 1] && (shared.empty() || shared.back() != all[k])) shared.push_back(all[k]);
  return shared;
}

}  // namespace

template <int dim>
void find_curved_edges(std::vector<Block<dim>>& blocks) {
  const auto common = shared_vertices(blocks);
  std::vector<PlacedEdge>
      edges;  // those that another block may have: of all edges they would be larger than the blocks
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    auto& block = blocks[k];
    const auto of_others = pairs_of(block, 1 << dim);
    block.curved = without(pairs_of(block, dim + 1), of_others);
    std::vector<char> is_common;
    for (const VertexId v : block.vertex) is_common.push_back(std::binary_search(common.begin(), common.end(), v));
    const auto add = [&](const std::vector<Edge>& some) {
      for (const auto& e : some)
        if (is_common[e[0]] && is_common[e[1]])
          edges.push_back({ascending(block.vertex[e[0]], block.vertex[e[1]]), static_cast<BlockId>(k), e});
    };
    add(of_others);
    add(block.curved);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::vector<Edge>> shared(blocks.size());
  for (auto from = edges.begin(), to = from; from != edges.end(); from = to) {
    while (to != edges.end() && to->vertices == from->vertices) ++to;
    if (std::prev(to)->block != from->block)
      for (auto e = from; e != to; ++e) shared[e->block].push_back(e->nodes);
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    std::sort(shared[k].begin(), shared[k].end());
    blocks[k].curved = without(blocks[k].curved, shared[k]);
  }
}

namespace {

template <int dim>
class WithCurvedEdges final : public BlockSource<dim> {
 public:
  explicit WithCurvedEdges(std::unique_ptr<BlockSource<dim>> of) : of_(std::move(of)) {}

  BlockId block_count() const override { return of_->block_count(); }
  int node_count(BlockId b) const override { return of_->node_count(b); }
  Block<dim> block(BlockId b) const override {
    std::vector<Block<dim>> around{of_->block(b)};
    for (const auto& beside : of_->neighbours(b)) around.push_back(of_->block(beside.block));
    find_curved_edges(around);
    return std::move(around[0]);
  }
  std::vector<Neighbour> neighbours(BlockId b) const override { return of_->neighbours(b); }
  const SetNames& block_sets() const override { return of_->block_sets(); }
  const std::vector<std::string>& facet_sets() const override { return of_->facet_sets(); }
  Warnings warnings() const override { return of_->warnings(); }
  std::vector<std::string> report() const override { return of_->report(); }

 private:
  std::unique_ptr<BlockSource<dim>> of_;
};

}  // namespace

template <int dim>
std::unique_ptr<BlockSource<dim>> with_curved_edges(std::unique_ptr<BlockSource<dim>> source) {
  return std::make_unique<WithCurvedEdges<dim>>(std::move(source));
}

template <int dim>
std::vector<std::array<int, 2>> curved_edges_off(const Block<dim>& block,
                                                 const std::function<bool(const TaggedFacet&)>& straightens) {
  if (block.curved.empty()) return {};
  std::vector<Edge> straight;
  for (const auto& facet : block.facets) {
    if (!straightens(facet)) continue;
    for (int i = 0; i < facet.count; ++i)
      for (int j = 0; j < i; ++j) straight.push_back(edge(facet.node[i], facet.node[j]));
  }
  sort_unique(straight);
  return without(block.curved, straight);
}

template void find_curved_edges(std::vector<Block<2>>&);
template void find_curved_edges(std::vector<Block<3>>&);
template std::unique_ptr<BlockSource<2>> with_curved_edges(std::unique_ptr<BlockSource<2>>);
template std::vector<std::array<int, 2>> curved_edges_off(const Block<2>&,
                                                          const std::function<bool(const TaggedFacet&)>&);
template std::vector<std::array<int, 2>> curved_edges_off(const Block<3>&,
                                                          const std::function<bool(const TaggedFacet&)>&);

}  // namespace voussoir
