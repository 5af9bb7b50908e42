#include "selection/marking.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {

std::vector<char> mark_bulk(const std::vector<double>& eta, double share, const Teuchos::Comm<int>& comm,
                            const RestParameters& numbers) {
  VOUSSOIR_EXPECT(share > 0 && share <= 1);
  const auto sum_from = [&](double cut) {
    double mine = 0;
    for (double e : eta)
      if (e >= cut) mine += e;
    return total_over_ranks(comm, mine);
  };
  double mine = 0;
  for (double e : eta) mine = std::max(mine, e);
  const double largest = largest_over_ranks(comm, mine);
  std::vector<char> marked(eta.size(), 0);
  if (largest == 0) return marked;
  // The largest cut that still holds the share, by bisection over the octaves below the largest value.
  const double wanted = share * sum_from(0.0);
  double low = -numbers.octaves, high = 0;
  if (share < 1)
    for (int k = 0; k < numbers.bisections; ++k) {
      const double middle = (low + high) / 2;
      (sum_from(largest * std::exp2(middle)) >= wanted ? low : high) = middle;
    }
  const double cut = share < 1 ? largest * std::exp2(low) : 0.0;
  for (std::size_t k = 0; k < eta.size(); ++k) marked[k] = eta[k] > 0 && eta[k] >= cut;
  return marked;
}

}  // namespace voussoir
