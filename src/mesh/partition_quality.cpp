#include "mesh/partition_quality.hpp"

#include <algorithm>

#include "linalg/reduce.hpp"

namespace voussoir {

PartitionQuality partition_quality(const std::vector<RankShare>& shares) {
  PartitionQuality quality;
  const auto ranks = static_cast<double>(shares.size());
  RankShare sum;
  double most = 0;
  for (const auto& share : shares) {
    sum.work += share.work;
    sum.vertices += share.vertices;
    sum.cut += share.cut;
    sum.neighbours += share.neighbours;
    most = std::max(most, share.work);
    quality.neighbours = std::max(quality.neighbours, share.neighbours);
  }
  if (sum.vertices > 0) quality.cut = sum.cut / sum.vertices;
  if (sum.work > 0) quality.imbalance = most * ranks / sum.work;
  quality.mean_neighbours = sum.neighbours / ranks;
  return quality;
}

double imbalance(const Teuchos::Comm<int>& comm, long long mine) {
  const long long sum = total_over_ranks(comm, mine), largest = largest_over_ranks(comm, mine);
  return sum > 0 ? static_cast<double>(largest) * comm.getSize() / static_cast<double>(sum) : 1.0;
}

}  // namespace voussoir
