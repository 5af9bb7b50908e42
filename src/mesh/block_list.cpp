#include "mesh/block_list.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "mesh/curved_edges.hpp"

namespace voussoir {
namespace {

template <int dim>
class ListedBlocks final : public BlockSource<dim> {
 public:
  explicit ListedBlocks(BlockList<dim> list) : list_(std::move(list)) {
    std::vector<std::vector<VertexId>> vertices;
    for (const auto& block : list_.blocks) {
      VOUSSOIR_CHECK(block.id == static_cast<BlockId>(vertices.size()));
      vertices.push_back(block.vertex);
    }
    graph_ = graph_of_shared_vertices(vertices);
  }
  BlockId block_count() const override { return static_cast<BlockId>(list_.blocks.size()); }
  int node_count(BlockId b) const override { return static_cast<int>(list_.blocks[b].vertex.size()); }
  Block<dim> block(BlockId b) const override {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    return list_.blocks[b];
  }
  std::vector<Neighbour> neighbours(BlockId b) const override {
    std::vector<Neighbour> all;
    for (int k = graph_.start[b]; k < graph_.start[b + 1]; ++k)
      all.push_back({graph_.neighbour[k], graph_.shared_vertices[k]});
    return all;
  }
  const SetNames& block_sets() const override { return list_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return list_.facet_sets; }
  Warnings warnings() const override { return list_.warnings; }
  std::vector<std::string> report() const override { return list_.report; }
  std::string picture() const override { return list_.picture; }

 private:
  BlockList<dim> list_;
  BlockGraph graph_;
};

}  // namespace

template <int dim>
std::unique_ptr<BlockSource<dim>> make_source(BlockList<dim> list) {
  if (list.quadratic) find_curved_edges(list.blocks);
  return std::make_unique<ListedBlocks<dim>>(std::move(list));
}

BlockGraph graph_of_shared_vertices(const std::vector<std::vector<VertexId>>& vertices_of_block) {
  std::vector<std::pair<VertexId, BlockId>> touched;
  for (std::size_t b = 0; b < vertices_of_block.size(); ++b)
    for (const VertexId v : vertices_of_block[b]) touched.emplace_back(v, static_cast<BlockId>(b));
  sort_unique(touched);

  std::vector<std::pair<BlockId, BlockId>> meetings;  // one entry per ordered pair of blocks and vertex they share
  for (std::size_t from = 0, to = 0; from < touched.size(); from = to) {
    while (to < touched.size() && touched[to].first == touched[from].first) ++to;
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t j = from; j < to; ++j)
        if (i != j) meetings.emplace_back(touched[i].second, touched[j].second);
  }
  std::sort(meetings.begin(), meetings.end());

  BlockGraph graph;
  graph.start.assign(vertices_of_block.size() + 1, 0);
  for (std::size_t from = 0, to = 0; from < meetings.size(); from = to) {
    while (to < meetings.size() && meetings[to] == meetings[from]) ++to;
    graph.neighbour.push_back(meetings[from].second);
    graph.shared_vertices.push_back(static_cast<int>(to - from));
    ++graph.start[meetings[from].first + 1];
  }
  for (std::size_t b = 0; b < vertices_of_block.size(); ++b) graph.start[b + 1] += graph.start[b];
  return graph;
}

template std::unique_ptr<BlockSource<2>> make_source(BlockList<2>);
template std::unique_ptr<BlockSource<3>> make_source(BlockList<3>);

}  // namespace voussoir
