#include "mesh/partition_quality.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {

PartitionQuality partition_quality(const BlockGraph& graph, const std::vector<int>& owner,
                                   const std::vector<double>& work, int ranks) {
  VOUSSOIR_CHECK(graph.start.size() == owner.size() + 1 && owner.size() == work.size());
  PartitionQuality quality;
  double all = 0, cut = 0;
  std::set<std::pair<int, int>> meet;
  std::vector<double> load(ranks, 0.0);
  for (std::size_t b = 0; b < owner.size(); ++b) {
    load[owner[b]] += work[b];
    for (int k = graph.start[b]; k < graph.start[b + 1]; ++k) {
      const int other = owner[graph.neighbour[k]];
      all += graph.shared_vertices[k];
      if (other == owner[b]) continue;
      cut += graph.shared_vertices[k];
      meet.emplace(owner[b], other);
    }
  }
  if (all > 0) quality.cut = cut / all;
  const double mean = std::accumulate(load.begin(), load.end(), 0.0) / ranks;
  if (mean > 0) quality.imbalance = *std::max_element(load.begin(), load.end()) / mean;
  std::vector<int> neighbours(ranks, 0);
  for (const auto& pair : meet) ++neighbours[pair.first];
  quality.neighbours = *std::max_element(neighbours.begin(), neighbours.end());
  quality.mean_neighbours = static_cast<double>(meet.size()) / ranks;
  return quality;
}

double imbalance(const Teuchos::Comm<int>& comm, long long mine) {
  const long long sum = total_over_ranks(comm, mine), largest = largest_over_ranks(comm, mine);
  return sum > 0 ? static_cast<double>(largest) * comm.getSize() / static_cast<double>(sum) : 1.0;
}

}  // namespace voussoir
