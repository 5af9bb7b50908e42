#include "mesh/block_list.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/agree.hpp"
#include "mesh/curved_edges.hpp"

namespace voussoir {
namespace {

template <int dim>
class ListedBlocks final : public BlockSource<dim> {
 public:
  explicit ListedBlocks(BlockList<dim> list) : list_(std::move(list)) {
    for (BlockId b = 0; b < block_count(); ++b) VOUSSOIR_CHECK(list_.blocks[b].id == b);
  }
  BlockId block_count() const override { return static_cast<BlockId>(list_.blocks.size()); }
  int node_count(BlockId b) const override { return static_cast<int>(list_.blocks[b].position.size()); }
  Block<dim> block(BlockId b) const override {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    return list_.blocks[b];
  }
  const BlockGraph& graph() const override {
    if (graph_.start.empty()) {
      std::vector<std::vector<VertexId>> vertices;
      for (const Block<dim>& block : list_.blocks) vertices.push_back(block.vertex);
      graph_ = graph_of_shared_vertices(vertices);
    }
    return graph_;
  }
  const std::vector<std::string>& block_sets() const override { return list_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return list_.facet_sets; }
  Warnings warnings() const override { return list_.warnings; }
  std::vector<std::string> report() const override { return list_.report; }
  std::string picture() const override { return list_.picture; }

 private:
  BlockList<dim> list_;
  mutable BlockGraph graph_;
};

void broadcast_warnings(const Teuchos::Comm<int>& comm, Warnings& warnings) {
  std::vector<std::string> words;
  std::vector<double> amounts;
  for (const Warning& w : warnings) {
    words.insert(words.end(), {w.what, w.where, w.when, w.text});
    amounts.push_back(w.how_much);
  }
  broadcast_strings(comm, words);
  broadcast_values(comm, amounts);
  warnings.clear();
  for (std::size_t k = 0; k < amounts.size(); ++k)
    warnings.push_back({words[4 * k], words[4 * k + 1], words[4 * k + 2], amounts[k], words[4 * k + 3]});
}

/// All blocks of a list, end to end.
template <int dim>
struct Packed {
  std::vector<std::string> names;
  std::vector<int> counts, sets, cells, facets, folds;  ///< counts: nodes, sets, cells, facets, folds of each block
  std::vector<double> positions;
  std::vector<VertexId> vertices;

  void pack(const Block<dim>& block) {
    names.push_back(block.name);
    counts.insert(counts.end(), {static_cast<int>(block.position.size()), static_cast<int>(block.sets.size()),
                                 static_cast<int>(block.cells.size()), static_cast<int>(block.facets.size()),
                                 static_cast<int>(block.folds.size())});
    for (const Vector<dim>& x : block.position) positions.insert(positions.end(), x.begin(), x.end());
    vertices.insert(vertices.end(), block.vertex.begin(), block.vertex.end());
    sets.insert(sets.end(), block.sets.begin(), block.sets.end());
    folds.insert(folds.end(), block.folds.begin(), block.folds.end());
    for (const Cell& cell : block.cells) {
      cells.push_back(cell.count);
      cells.insert(cells.end(), cell.node.begin(), cell.node.end());
    }
    for (const TaggedFacet& facet : block.facets) {
      facets.insert(facets.end(), {facet.count, facet.set});
      facets.insert(facets.end(), facet.node.begin(), facet.node.end());
    }
  }

  void broadcast(const Teuchos::Comm<int>& comm) {
    broadcast_strings(comm, names);
    broadcast_values(comm, counts);
    broadcast_values(comm, positions);
    broadcast_values(comm, vertices);
    broadcast_values(comm, sets);
    broadcast_values(comm, cells);
    broadcast_values(comm, facets);
    broadcast_values(comm, folds);
  }

  std::vector<Block<dim>> unpacked() const {
    std::vector<Block<dim>> blocks(names.size());
    auto x = positions.begin();
    auto v = vertices.begin();
    auto s = sets.begin(), c = cells.begin(), f = facets.begin(), d = folds.begin();
    for (std::size_t b = 0; b < names.size(); ++b) {
      Block<dim>& block = blocks[b];
      const int* count = &counts[5 * b];
      block.id = static_cast<BlockId>(b);
      block.name = names[b];
      block.position.resize(count[0]);
      for (Vector<dim>& position : block.position)
        for (double& component : position) component = *x++;
      block.vertex.assign(v, v + count[0]);
      v += count[0];
      block.sets.assign(s, s + count[1]);
      s += count[1];
      block.folds.assign(d, d + count[4]);
      d += count[4];
      block.cells.resize(count[2]);
      for (Cell& cell : block.cells) {
        cell.count = *c++;
        for (int& node : cell.node) node = *c++;
      }
      block.facets.resize(count[3]);
      for (TaggedFacet& facet : block.facets) {
        facet.count = *f++;
        facet.set = *f++;
        for (int& node : facet.node) node = *f++;
      }
    }
    return blocks;
  }
};

}  // namespace

template <int dim>
void broadcast_blocks(const Teuchos::Comm<int>& comm, BlockList<dim>& list) {
  Packed<dim> packed;
  for (const Block<dim>& block : list.blocks) packed.pack(block);
  broadcast_strings(comm, list.block_sets);
  broadcast_strings(comm, list.facet_sets);
  broadcast_warnings(comm, list.warnings);
  broadcast_strings(comm, list.report);
  std::vector<int> quadratic{list.quadratic};
  broadcast_values(comm, quadratic);
  list.quadratic = quadratic.front() != 0;
  packed.broadcast(comm);
  if (comm.getRank() != 0) list.blocks = packed.unpacked();
}

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

template void broadcast_blocks(const Teuchos::Comm<int>&, BlockList<2>&);
template void broadcast_blocks(const Teuchos::Comm<int>&, BlockList<3>&);
template std::unique_ptr<BlockSource<2>> make_source(BlockList<2>);
template std::unique_ptr<BlockSource<3>> make_source(BlockList<3>);

}  // namespace voussoir
