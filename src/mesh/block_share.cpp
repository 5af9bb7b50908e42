#include "mesh/block_share.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/sort_unique.hpp"
#include "linalg/parcels.hpp"

namespace voussoir {
namespace {

struct OwnerOfBlock {
  BlockId block;
  int owner;
};

/// Blocks beside those of a rank that are not its own.
template <int dim>
std::vector<BlockId> halo_of(const BlockSource<dim>& source, const std::vector<BlockId>& owned) {
  std::vector<BlockId> halo;
  for (const BlockId b : owned)
    for (const auto& beside : source.neighbours(b))
      if (!std::binary_search(owned.begin(), owned.end(), beside.block)) halo.push_back(beside.block);
  sort_unique(halo);
  return halo;
}

/// @param owner_here  of the blocks that this rank reads
template <int dim>
BlockShare share_of(const BlockSource<dim>& source, const std::vector<int>& owner_here,
                    const Teuchos::Comm<int>& comm) {
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  BlockShare share;
  Post<BlockId> hand_over(comm);
  for (BlockId b = read.from; b < read.to; ++b) hand_over.add(owner_here[b - read.from], b);
  share.owned = std::move(hand_over).send_all();
  std::sort(share.owned.begin(), share.owned.end());
  source.bring(share.owned, comm);
  share.halo = halo_of(source, share.owned);
  source.bring(share.halo, comm);
  Post<BlockId> ask(comm);
  for (const BlockId b : share.halo) ask.add(source.reader_of(b, comm.getSize()), b);
  Post<OwnerOfBlock> answer(comm);
  for (const auto& parcel : std::move(ask).send())
    for (const BlockId b : parcel.items) answer.add(parcel.rank, {b, owner_here[b - read.from]});
  std::map<BlockId, int> owner;
  for (const auto& [block, rank] : std::move(answer).send_all()) owner[block] = rank;
  for (const BlockId b : share.halo) share.owner_of_halo.push_back(owner.at(b));
  return share;
}

}  // namespace

template <int dim>
BlockShare share_out(const BlockSource<dim>& source, const Teuchos::Comm<int>& comm,
                     const PartitionSettings& settings) {
  const auto read = source.read_by(comm.getRank(), comm.getSize());
  std::vector<double> weight;
  for (BlockId b = read.from; b < read.to; ++b) weight.push_back(static_cast<double>(dim) * source.node_count(b));
  return share_of(source, partition(graph_of(source, read), weight, source.block_count(), comm, settings), comm);
}

template <int dim>
BlockShare share_of_owners(const BlockSource<dim>& source, const std::vector<int>& owner_of_block, int rank) {
  BlockShare share;
  for (BlockId b = 0; b < source.block_count(); ++b)
    if (owner_of_block[b] == rank) share.owned.push_back(b);
  share.halo = halo_of(source, share.owned);
  for (const BlockId b : share.halo) share.owner_of_halo.push_back(owner_of_block[b]);
  return share;
}

template BlockShare share_out(const BlockSource<2>&, const Teuchos::Comm<int>&, const PartitionSettings&);
template BlockShare share_out(const BlockSource<3>&, const Teuchos::Comm<int>&, const PartitionSettings&);
template BlockShare share_of_owners(const BlockSource<2>&, const std::vector<int>&, int);
template BlockShare share_of_owners(const BlockSource<3>&, const std::vector<int>&, int);

}  // namespace voussoir
