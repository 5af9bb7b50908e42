#include "mesh/read_blocks.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"
#include "linalg/shared_warnings.hpp"
#include "mesh/block_bytes.hpp"
#include "mesh/curved_edges.hpp"
#include "mesh/kept_blocks.hpp"

namespace voussoir {
namespace {

using Rows = std::map<BlockId, std::vector<Neighbour>>;

template <int dim>
class ReadBlocks final : public BlockSource<dim> {
 public:
  /// @param rows  neighbours of these blocks
  ReadBlocks(BlockList<dim> of_span, BlockId count, Rows rows)
      : count_(count), names_(std::move(of_span)), neighbours_(std::move(rows)) {
    const auto names = std::exchange(names_.block_sets, {});  // sets without blocks are none
    for (auto& block : names_.blocks) {
      for (const int set : block.sets) names_.block_sets.learn(set, names[set]);
      kept_.add(std::move(block));
    }
    names_.blocks = std::vector<Block<dim>>();
  }
  BlockId block_count() const override { return count_; }
  int node_count(BlockId b) const override { return static_cast<int>(kept_.vertices(b).size()); }
  Block<dim> block(BlockId b) const override { return kept_[b]; }
  std::vector<Neighbour> neighbours(BlockId b) const override {
    VOUSSOIR_CHECK(kept_.has(b) && "a block that was not brought to this rank");
    return neighbours_.at(b);
  }
  /// A reader sends a block to its owner and to those who own what touches it: messages are no more than a few times
  /// the share of a rank.
  void bring(const std::vector<BlockId>& wanted, const Teuchos::Comm<int>& comm) const override {
    if (comm.getSize() == 1) return;
    Post<BlockId> ask(comm);
    for (const BlockId b : wanted)
      if (!kept_.has(b)) ask.add(this->reader_of(b, comm.getSize()), b);
    std::vector<Parcel<char>> answer;
    for (const auto& asked : std::move(ask).send()) {
      std::vector<BlockToSend<dim>> blocks;
      for (const BlockId b : asked.items) blocks.emplace_back(kept_[b], names_.block_sets, neighbours_.at(b));
      const auto bytes = bytes_of(blocks);
      answer.push_back({asked.rank, {bytes.begin(), bytes.end()}});
    }
    for (const auto& parcel : exchange_parcels(std::move(answer), comm))
      for (auto& one : blocks_of_bytes<dim>({parcel.items.begin(), parcel.items.end()})) {
        one.teach(names_.block_sets);
        neighbours_.emplace(one.block.id, std::move(one.neighbours));
        kept_.add(std::move(one.block));
      }
  }
  const SetNames& block_sets() const override { return names_.block_sets; }
  const std::vector<std::string>& facet_sets() const override { return names_.facet_sets; }
  Warnings warnings() const override { return names_.warnings; }
  std::vector<std::string> report() const override { return names_.report; }
  std::string picture() const override { return names_.picture; }

 private:
  BlockId count_;
  mutable BlockList<dim> names_;  ///< without its blocks
  mutable KeptBlocks<dim> kept_;  ///< those of the span, and what is brought
  mutable Rows neighbours_;       ///< of these
};

/// Who shares how many vertices with whom. A vertex is looked after by the rank that its number tells. Collective.
/// @return  of the blocks of this rank
template <int dim>
Rows neighbours_by_vertices(const std::vector<Block<dim>>& blocks, const Teuchos::Comm<int>& comm) {
  struct Touch {
    VertexId vertex;
    BlockId block;
    int reader;
    bool operator<(const Touch& o) const { return std::tie(vertex, block) < std::tie(o.vertex, o.block); }
  };
  Post<Touch> there(comm);
  for (const auto& block : blocks)
    for (const VertexId v : block.vertex)
      there.add(static_cast<int>(v % comm.getSize()), {v, block.id, comm.getRank()});
  auto touched = std::move(there).send_all();
  std::sort(touched.begin(), touched.end());
  struct Meeting {  // one for every vertex that two blocks share
    BlockId block, other;
    bool operator<(const Meeting& o) const { return std::tie(block, other) < std::tie(o.block, o.other); }
    bool operator==(const Meeting& o) const { return block == o.block && other == o.other; }
  };
  Post<Meeting> back(comm);
  for (std::size_t from = 0, to = 0; from < touched.size(); from = to) {
    while (to < touched.size() && touched[to].vertex == touched[from].vertex) ++to;
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t j = from; j < to; ++j)
        if (i != j) back.add(touched[i].reader, {touched[i].block, touched[j].block});
  }
  auto meetings = std::move(back).send_all();
  std::sort(meetings.begin(), meetings.end());
  Rows rows;
  for (const auto& block : blocks) rows[block.id];
  for (std::size_t from = 0, to = 0; from < meetings.size(); from = to) {
    while (to < meetings.size() && meetings[to] == meetings[from]) ++to;
    rows[meetings[from].block].push_back({meetings[from].other, static_cast<int>(to - from)});
  }
  return rows;
}

/// Finds the edges that bend of some blocks, from them and those that touch them.
template <int dim>
void find_curved_edges_of(std::vector<Block<dim>>& blocks, const BlockSource<dim>& source) {
  const auto own = blocks.size();
  std::map<BlockId, char> here;
  for (const auto& block : blocks) here[block.id];
  for (std::size_t k = 0; k < own; ++k)
    for (const auto& beside : source.neighbours(blocks[k].id))
      if (here.emplace(beside.block, 0).second) blocks.push_back(source.block(beside.block));
  find_curved_edges(blocks);
  blocks.resize(own);
}

}  // namespace

template <int dim>
std::unique_ptr<BlockSource<dim>> make_source_of_readers(BlockList<dim> list, const Teuchos::Comm<int>& comm) {
  const auto count = static_cast<BlockId>(total_over_ranks(comm, static_cast<long long>(list.blocks.size())));
  const auto span = span_read_by(comm.getRank(), comm.getSize(), count);
  VOUSSOIR_CHECK(static_cast<BlockId>(list.blocks.size()) == span.to - span.from);
  for (BlockId b = span.from; b < span.to; ++b) VOUSSOIR_CHECK(list.blocks[b - span.from].id == b);
  auto rows = neighbours_by_vertices(list.blocks, comm);
  if (list.quadratic) {
    const ReadBlocks<dim> linear(list, count, rows);
    bring_neighbours<dim>(linear, span, comm);
    find_curved_edges_of<dim>(list.blocks, linear);
  }
  return std::make_unique<ReadBlocks<dim>>(std::move(list), count, std::move(rows));
}

template <int dim>
BlockList<dim> without_blocks(const BlockList<dim>& of_first, const Teuchos::Comm<int>& comm) {
  BlockList<dim> list;
  list.facet_sets = of_first.facet_sets;
  list.warnings = of_first.warnings;
  list.report = of_first.report;
  if (comm.getRank() == 0) list.picture = of_first.picture;
  list.quadratic = any_of_ranks(comm, comm.getRank() == 0 && of_first.quadratic);
  broadcast_strings(comm, list.facet_sets);
  broadcast_warnings(comm, list.warnings);
  broadcast_strings(comm, list.report);
  return list;
}

std::string part_of_first(const Teuchos::Comm<int>& comm, const std::function<std::string(int reader)>& part) {
  std::string mine;
  for (int reader = 0; reader < comm.getSize(); ++reader) {
    std::vector<Parcel<char>> parcels;
    if (comm.getRank() == 0) {
      const auto bytes = part(reader);
      parcels.push_back({reader, {bytes.begin(), bytes.end()}});
    }
    for (const auto& parcel : exchange_parcels(std::move(parcels), comm))
      mine.assign(parcel.items.begin(), parcel.items.end());
  }
  return mine;
}

template <int dim>
BlockList<dim> handed_out(BlockList<dim> of_first, const Teuchos::Comm<int>& comm) {
  if (comm.getSize() == 1) return of_first;
  auto list = without_blocks(of_first, comm);
  const auto bytes = part_of_first(comm, [&](int reader) {
    std::vector<BlockToSend<dim>> theirs;
    const auto span = span_read_by(reader, comm.getSize(), static_cast<BlockId>(of_first.blocks.size()));
    for (BlockId b = span.from; b < span.to; ++b)
      theirs.emplace_back(std::exchange(of_first.blocks[b], {}), of_first.block_sets);
    return bytes_of(theirs);
  });
  for (auto& one : blocks_of_bytes<dim>(bytes)) {
    one.teach(list.block_sets);
    list.blocks.push_back(std::move(one.block));
  }
  return list;
}

template std::unique_ptr<BlockSource<2>> make_source_of_readers(BlockList<2>, const Teuchos::Comm<int>&);
template std::unique_ptr<BlockSource<3>> make_source_of_readers(BlockList<3>, const Teuchos::Comm<int>&);
template BlockList<2> without_blocks(const BlockList<2>&, const Teuchos::Comm<int>&);
template BlockList<3> without_blocks(const BlockList<3>&, const Teuchos::Comm<int>&);
template BlockList<2> handed_out(BlockList<2>, const Teuchos::Comm<int>&);
template BlockList<3> handed_out(BlockList<3>, const Teuchos::Comm<int>&);

}  // namespace voussoir
