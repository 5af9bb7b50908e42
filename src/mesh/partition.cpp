#include "mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/words.hpp"
#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "mesh/partition_by_all.hpp"

namespace voussoir {
namespace {

/// Per rank. With up to two equal blocks per rank METIS k-way leaves parts empty and says so on the screen (seen on
/// arches of 3 to 120 blocks and up to 32 ranks); bisection never did.
constexpr std::size_t blocks_for_k_way = 8;

bool is_connected(const BlockGraph& graph) {
  std::vector<char> seen(graph.start.size() - 1, 0);
  std::vector<BlockId> to_visit{0};
  seen[0] = 1;
  std::size_t count = 1;
  while (!to_visit.empty()) {
    const BlockId b = to_visit.back();
    to_visit.pop_back();
    for (int k = graph.start[b]; k < graph.start[b + 1]; ++k) {
      const BlockId other = graph.neighbour[k];
      if (seen[other]) continue;
      seen[other] = 1;
      ++count;
      to_visit.push_back(other);
    }
  }
  return count == seen.size();
}

/// Blocks in the order of their numbers: each rank takes its share of what is left, and leaves one for each rank to
/// come.
std::vector<int> cut_by_number(const std::vector<double>& weights, int ranks) {
  const int blocks = static_cast<int>(weights.size());
  double left = std::accumulate(weights.begin(), weights.end(), 0.0), taken = 0, share = left / ranks;
  std::vector<int> rank_of_block(weights.size());
  int rank = 0;
  for (int b = 0; b < blocks; ++b) {
    const bool one_left_for_each = blocks - b <= ranks - 1 - rank;
    if (taken > 0 && rank < ranks - 1 && (taken + weights[b] / 2 > share || one_left_for_each)) {
      ++rank;
      left -= taken;
      taken = 0;
      share = left / (ranks - rank);
    }
    rank_of_block[b] = rank;
    taken += weights[b];
  }
  return rank_of_block;
}

bool every_rank_has_a_block(const std::vector<int>& rank_of_block, int ranks) {
  std::vector<char> used(ranks, 0);
  for (const int rank : rank_of_block) used[rank] = 1;
  return std::find(used.begin(), used.end(), 0) == used.end();
}

/// A block heavier than the share of a rank fills a rank by itself, however heavy it is. METIS leaves ranks empty and
/// complains on the screen unless such a block counts as just one share of what the others weigh.
double share_of_a_rank(std::vector<double> weights, int ranks) {
  std::sort(weights.begin(), weights.end(), std::greater<>());
  double left = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t b = 0; ranks > 1 && weights[b] > left / ranks; ++b, --ranks) left -= weights[b];
  return left / ranks;
}

/// METIS counts in integers: a total of at most 1e9 leaves room below 2^31.
std::vector<idx_t> whole_weights(const std::vector<double>& weights, int ranks) {
  const double share = share_of_a_rank(weights, ranks), scale = std::min(1.0, 1e9 / (share * ranks));
  std::vector<idx_t> whole(weights.size());
  for (std::size_t b = 0; b < weights.size(); ++b) {
    VOUSSOIR_EXPECT(weights[b] > 0);
    whole[b] = std::max<idx_t>(1, static_cast<idx_t>(std::min(weights[b], share) * scale));
  }
  return whole;
}

enum class MetisMethod { k_way, bisection };

std::vector<int> metis(const BlockGraph& graph, const std::vector<double>& weights, int ranks, MetisMethod division) {
  idx_t blocks = static_cast<idx_t>(weights.size()), constraints = 1, parts = ranks, cut = 0;
  std::vector<idx_t> start(graph.start.begin(), graph.start.end());
  std::vector<idx_t> neighbour(graph.neighbour.begin(), graph.neighbour.end());
  std::vector<idx_t> edge_weight(graph.shared_vertices.begin(), graph.shared_vertices.end());
  std::vector<idx_t> vertex_weight = whole_weights(weights, ranks), part(weights.size(), 0);
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // any fixed number: the same parts in every run
  options[METIS_OPTION_NUMBERING] = 0;
  const bool k_way = division == MetisMethod::k_way;
  if (k_way && ranks <= 4 && is_connected(graph)) options[METIS_OPTION_CONTIG] = 1;
  const auto divide = k_way ? METIS_PartGraphKway : METIS_PartGraphRecursive;
  const int outcome = divide(&blocks, &constraints, start.data(), neighbour.data(), vertex_weight.data(), nullptr,
                             edge_weight.data(), &parts, nullptr, nullptr, options, &cut, part.data());
  if (outcome == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (outcome != METIS_OK)
    throw std::runtime_error("METIS could not divide " + counted(blocks, "block") + " among " + counted(ranks, "rank") +
                             " (its code: " + std::to_string(outcome) + ").");
  return std::vector<int>(part.begin(), part.end());
}

}  // namespace

std::vector<int> partition(const BlockGraph& graph, const std::vector<double>& vertex_weights, int ranks) {
  VOUSSOIR_CHECK(ranks >= 1);
  VOUSSOIR_CHECK(graph.start.size() == vertex_weights.size() + 1);
  std::vector<int> rank_of_block(vertex_weights.size(), 0);
  if (ranks == 1) return rank_of_block;
  if (static_cast<std::size_t>(ranks) >= vertex_weights.size()) {
    std::iota(rank_of_block.begin(), rank_of_block.end(), 0);
    return rank_of_block;
  }
  if (graph.neighbour.empty()) return cut_by_number(vertex_weights, ranks);
  if (vertex_weights.size() >= blocks_for_k_way * static_cast<std::size_t>(ranks)) {
    rank_of_block = metis(graph, vertex_weights, ranks, MetisMethod::k_way);
    if (every_rank_has_a_block(rank_of_block, ranks)) return rank_of_block;
  }
  rank_of_block = metis(graph, vertex_weights, ranks, MetisMethod::bisection);
  return every_rank_has_a_block(rank_of_block, ranks) ? rank_of_block : cut_by_number(vertex_weights, ranks);
}

namespace {

/// The first rank brings all rows together and sends each its blocks' ranks.
std::vector<int> on_first(const BlockGraph& rows, const std::vector<double>& vertex_weights,
                          const Teuchos::Comm<int>& comm) {
  const int here = static_cast<int>(vertex_weights.size());
  std::vector<int> lengths;
  for (int b = 0; b < here; ++b) lengths.push_back(rows.start[b + 1] - rows.start[b]);
  BlockGraph all;
  lengths = gather_on_first(lengths, comm);
  all.start.assign(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), all.start.begin() + 1);
  all.neighbour = gather_on_first(rows.neighbour, comm);
  all.shared_vertices = gather_on_first(rows.shared_vertices, comm);
  const auto weights = gather_on_first(vertex_weights, comm);
  const auto counts = gather_on_first(std::vector<int>{here}, comm);
  std::vector<int> rank_of_block;
  on_first_rank(comm, [&] { rank_of_block = partition(all, weights, comm.getSize()); });
  std::vector<Parcel<int>> answer;
  auto next = rank_of_block.begin();
  for (std::size_t rank = 0; rank < counts.size(); next += counts[rank++])
    answer.push_back({static_cast<int>(rank), std::vector<int>(next, next + counts[rank])});
  const auto came = exchange_parcels(std::move(answer), comm);
  return came.empty() ? std::vector<int>() : came.front().items;
}

}  // namespace

std::vector<int> partition(const BlockGraph& rows, const std::vector<double>& vertex_weights, long long blocks,
                           const Teuchos::Comm<int>& comm, const PartitionSettings& settings) {
  VOUSSOIR_CHECK(rows.start.size() == vertex_weights.size() + 1);
  if (comm.getSize() == 1) return std::vector<int>(vertex_weights.size(), 0);
  const auto here = static_cast<long long>(vertex_weights.size());
  if (blocks <= settings.most_on_first || largest_over_ranks(comm, here) == blocks)
    return on_first(rows, vertex_weights, comm);
  auto rank_of_block = divided_by_all(rows, vertex_weights, comm);
  // Where it left a rank without blocks each takes those it reads, which are as many.
  std::vector<Parcel<char>> notes;
  std::vector<char> used(comm.getSize(), 0);
  for (const int rank : rank_of_block)
    if (!std::exchange(used[rank], 1)) notes.push_back({rank, {1}});
  if (!all_of_ranks(comm, !exchange_parcels(std::move(notes), comm).empty()))
    rank_of_block.assign(vertex_weights.size(), comm.getRank());
  return rank_of_block;
}

}  // namespace voussoir
