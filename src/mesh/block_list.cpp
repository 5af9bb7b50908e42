#include "mesh/block_list.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/sort_unique.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "linalg/shared_warnings.hpp"
#include "mesh/block_bytes.hpp"
#include "mesh/curved_edges.hpp"
#include "mesh/kept_blocks.hpp"

namespace voussoir {
namespace {

/// Names and words of a list, and those of its blocks that are here.
template <int dim>
class NamedBlocks : public BlockSource<dim> {
 public:
  explicit NamedBlocks(BlockList<dim> list) : names_(std::move(list)) {
    in_list_ = static_cast<BlockId>(names_.blocks.size());
    for (BlockId b = 0; b < in_list_; ++b) {
      VOUSSOIR_CHECK(names_.blocks[b].id == b);
      kept_.add(std::move(names_.blocks[b]));
    }
    names_.blocks = std::vector<Block<dim>>();
  }
  int node_count(BlockId b) const override { return static_cast<int>(kept_.vertices(b).size()); }
  Block<dim> block(BlockId b) const override {
    VOUSSOIR_EXPECT(b >= 0 && b < this->block_count());
    return kept_[b];
  }
  const std::vector<std::string>& block_sets() const override { return names_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return names_.facet_sets; }
  Warnings warnings() const override { return names_.warnings; }
  std::vector<std::string> report() const override { return names_.report; }
  std::string picture() const override { return names_.picture; }

 protected:
  /// Of a block of the list.
  std::vector<Neighbour> neighbours_in_list(BlockId b) const {
    if (graph_.start.empty()) {
      std::vector<std::vector<VertexId>> vertices;
      for (BlockId other = 0; other < in_list_; ++other) vertices.push_back(kept_.vertices(other));
      graph_ = graph_of_shared_vertices(vertices);
    }
    std::vector<Neighbour> all;
    for (int k = graph_.start[b]; k < graph_.start[b + 1]; ++k)
      all.push_back({graph_.neighbour[k], graph_.shared_vertices[k]});
    return all;
  }

  BlockId in_list_ = 0;
  mutable KeptBlocks<dim> kept_;  ///< those of the list, and what is brought

 private:
  BlockList<dim> names_;      ///< without its blocks
  mutable BlockGraph graph_;  ///< found when first asked for
};

template <int dim>
class ListedBlocks final : public NamedBlocks<dim> {
 public:
  using NamedBlocks<dim>::NamedBlocks;
  BlockId block_count() const override { return this->in_list_; }
  std::vector<Neighbour> neighbours(BlockId b) const override { return this->neighbours_in_list(b); }
};

/// The list is on the first rank, others have what they have been brought.
template <int dim>
class BroughtBlocks final : public NamedBlocks<dim> {
 public:
  BroughtBlocks(BlockList<dim> list, BlockId count, bool has_list)
      : NamedBlocks<dim>(std::move(list)), count_(count), has_list_(has_list) {}

  BlockId block_count() const override { return count_; }
  std::vector<Neighbour> neighbours(BlockId b) const override {
    if (has_list_) return this->neighbours_in_list(b);
    VOUSSOIR_CHECK(this->kept_.has(b) && "a block that was not brought to this rank");
    return neighbours_.at(b);
  }
  int reader_of(BlockId, int) const override { return 0; }
  BlockSpan read_by(int rank, int) const override { return {0, rank == 0 ? count_ : 0}; }

  void bring(const std::vector<BlockId>& wanted, const Teuchos::Comm<int>& comm) const override {
    if (comm.getSize() == 1) return;
    std::vector<BlockId> missing;
    for (const BlockId b : wanted)
      if (!has_list_ && !this->kept_.has(b)) missing.push_back(b);
    // Messages are copies of blocks: of all ranks' together no more at a time than the share of one of them.
    const auto most = static_cast<std::size_t>(std::max(1, count_ / (comm.getSize() * comm.getSize())));
    for (std::size_t from = 0; any_of_ranks(comm, from < missing.size()); from += most) {
      const auto first = missing.begin() + static_cast<std::ptrdiff_t>(std::min(from, missing.size()));
      const auto behind = missing.begin() + static_cast<std::ptrdiff_t>(std::min(from + most, missing.size()));
      bring_at_once({first, behind}, comm);
    }
  }

 private:
  void bring_at_once(std::vector<BlockId> missing, const Teuchos::Comm<int>& comm) const {
    std::vector<Parcel<char>> answer;
    for (const auto& asked : exchange_parcels<BlockId>({{0, std::move(missing)}}, comm)) {
      std::vector<BlockWithNeighbours<dim>> blocks;
      for (const BlockId b : asked.items) blocks.push_back({this->kept_[b], this->neighbours_in_list(b)});
      const auto bytes = bytes_of(blocks);
      answer.push_back({asked.rank, {bytes.begin(), bytes.end()}});
    }
    for (const auto& parcel : exchange_parcels(std::move(answer), comm))
      for (auto& one : blocks_of_bytes<dim>({parcel.items.begin(), parcel.items.end()})) {
        neighbours_.emplace(one.block.id, std::move(one.neighbours));
        this->kept_.add(std::move(one.block));
      }
  }

  BlockId count_;
  bool has_list_;
  mutable std::map<BlockId, std::vector<Neighbour>> neighbours_;  ///< of what was brought
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
