#include "mesh/block_list.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "linalg/shared_warnings.hpp"
#include "mesh/block_bytes.hpp"
#include "mesh/curved_edges.hpp"

namespace voussoir {
namespace {

/// Names and words of a list, without its blocks.
template <int dim>
class NamedBlocks : public BlockSource<dim> {
 public:
  explicit NamedBlocks(BlockList<dim> list) : list_(std::move(list)) {
    for (std::size_t b = 0; b < list_.blocks.size(); ++b) VOUSSOIR_CHECK(list_.blocks[b].id == static_cast<BlockId>(b));
  }
  const std::vector<std::string>& block_sets() const override { return list_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return list_.facet_sets; }
  Warnings warnings() const override { return list_.warnings; }
  std::vector<std::string> report() const override { return list_.report; }
  std::string picture() const override { return list_.picture; }

 protected:
  /// Of a block of the list.
  std::vector<Neighbour> neighbours_in_list(BlockId b) const {
    if (graph_.start.empty()) {
      std::vector<std::vector<VertexId>> vertices;
      for (const Block<dim>& block : list_.blocks) vertices.push_back(block.vertex);
      graph_ = graph_of_shared_vertices(vertices);
    }
    std::vector<Neighbour> all;
    for (int k = graph_.start[b]; k < graph_.start[b + 1]; ++k)
      all.push_back({graph_.neighbour[k], graph_.shared_vertices[k]});
    return all;
  }

  BlockList<dim> list_;

 private:
  mutable BlockGraph graph_;  ///< found when first asked for
};

template <int dim>
class ListedBlocks final : public NamedBlocks<dim> {
 public:
  using NamedBlocks<dim>::NamedBlocks;
  BlockId block_count() const override { return static_cast<BlockId>(this->list_.blocks.size()); }
  int node_count(BlockId b) const override { return static_cast<int>(this->list_.blocks[b].position.size()); }
  Block<dim> block(BlockId b) const override {
    VOUSSOIR_EXPECT(b >= 0 && b < block_count());
    return this->list_.blocks[b];
  }
  std::vector<Neighbour> neighbours(BlockId b) const override { return this->neighbours_in_list(b); }
};

/// The list is on the first rank, others have what they have been brought.
template <int dim>
class BroughtBlocks final : public NamedBlocks<dim> {
 public:
  BroughtBlocks(BlockList<dim> list, BlockId count, bool has_list)
      : NamedBlocks<dim>(std::move(list)), count_(count), has_list_(has_list) {}

  BlockId block_count() const override { return count_; }
  int node_count(BlockId b) const override { return static_cast<int>(here(b).position.size()); }
  Block<dim> block(BlockId b) const override { return here(b); }
  std::vector<Neighbour> neighbours(BlockId b) const override {
    return has_list_ ? this->neighbours_in_list(b) : brought(b).neighbours;
  }
  int reader_of(BlockId, int) const override { return 0; }
  BlockSpan read_by(int rank, int) const override { return {0, rank == 0 ? count_ : 0}; }

  void bring(const std::vector<BlockId>& wanted, const Teuchos::Comm<int>& comm) const override {
    if (comm.getSize() == 1) return;
    std::vector<BlockId> missing;
    for (const BlockId b : wanted)
      if (!has_list_ && !brought_.count(b)) missing.push_back(b);
    std::vector<Parcel<char>> answer;
    for (const auto& asked : exchange_parcels<BlockId>({{0, std::move(missing)}}, comm)) {
      std::vector<BlockWithNeighbours<dim>> blocks;
      for (const BlockId b : asked.items) blocks.push_back({this->list_.blocks[b], this->neighbours_in_list(b)});
      const auto bytes = bytes_of(blocks);
      answer.push_back({asked.rank, {bytes.begin(), bytes.end()}});
    }
    for (const auto& parcel : exchange_parcels(std::move(answer), comm))
      for (auto& one : blocks_of_bytes<dim>({parcel.items.begin(), parcel.items.end()})) {
        const BlockId b = one.block.id;
        brought_.emplace(b, std::move(one));
      }
  }

 private:
  const BlockWithNeighbours<dim>& brought(BlockId b) const {
    const auto found = brought_.find(b);
    VOUSSOIR_CHECK(found != brought_.end() && "a block that was not brought to this rank");
    return found->second;
  }
  const Block<dim>& here(BlockId b) const {
    VOUSSOIR_EXPECT(b >= 0 && b < count_);
    return has_list_ ? this->list_.blocks[b] : brought(b).block;
  }

  BlockId count_;
  bool has_list_;
  mutable std::map<BlockId, BlockWithNeighbours<dim>> brought_;
};

}  // namespace

template <int dim>
std::unique_ptr<BlockSource<dim>> make_source(BlockList<dim> list) {
  if (list.quadratic) find_curved_edges(list.blocks);
  return std::make_unique<ListedBlocks<dim>>(std::move(list));
}

template <int dim>
std::unique_ptr<BlockSource<dim>> make_source_on_first(BlockList<dim> list, const Teuchos::Comm<int>& comm) {
  const bool has_list = comm.getRank() == 0;
  if (!has_list) list = {};
  on_first_rank(comm, [&] {
    if (list.quadratic) find_curved_edges(list.blocks);
  });
  auto count = static_cast<BlockId>(list.blocks.size());
  Teuchos::broadcast(comm, 0, Teuchos::outArg(count));
  broadcast_strings(comm, list.block_sets);
  broadcast_strings(comm, list.facet_sets);
  broadcast_warnings(comm, list.warnings);
  broadcast_strings(comm, list.report);
  return std::make_unique<BroughtBlocks<dim>>(std::move(list), count, has_list);
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
template std::unique_ptr<BlockSource<2>> make_source_on_first(BlockList<2>, const Teuchos::Comm<int>&);
template std::unique_ptr<BlockSource<3>> make_source_on_first(BlockList<3>, const Teuchos::Comm<int>&);

}  // namespace voussoir
