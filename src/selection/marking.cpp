#include "selection/marking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

// Bisections that one sum over the ranks does at once.
constexpr int at_once = 10, parts = 1 << at_once;
static_assert(RestParameters::bisections % at_once == 0);

/// The largest cut that still holds a sum of values, by bisection over the octaves below the largest value.
double cut_that_holds(const std::vector<double>& eta, double share, double largest, const Teuchos::Comm<int>& comm) {
  double low = -RestParameters::octaves, width = RestParameters::octaves, above = 0, wanted = 0;
  double behind = std::numeric_limits<double>::infinity();  // from there on values are in `above`
  std::vector<double> edges(parts);
  for (int done = 0; done < RestParameters::bisections; done += at_once) {
    width /= parts;
    for (int k = 0; k < parts; ++k) edges[k] = largest * std::exp2(low + k * width);
    std::array<double, parts + 1> sums{};  // between edges; and of all
    for (const double e : eta) {
      sums[parts] += e;
      if (e < edges[0] || e >= behind) continue;
      sums[std::upper_bound(edges.begin(), edges.end(), e) - edges.begin() - 1] += e;
    }
    sums = total_of_each(comm, sums);
    if (done == 0) wanted = share * sums[parts];
    int k = parts - 1;
    for (; k > 0 && above + sums[k] < wanted; --k) above += sums[k];
    if (k + 1 < parts) behind = edges[k + 1];
    low += k * width;
  }
  return largest * std::exp2(low);
}

}  // namespace

std::vector<char> mark_bulk(const std::vector<double>& eta, double share, const Teuchos::Comm<int>& comm) {
  VOUSSOIR_EXPECT(share > 0 && share <= 1);
  double mine = 0;
  for (double e : eta) mine = std::max(mine, e);
  const double largest = largest_over_ranks(comm, mine);
  std::vector<char> marked(eta.size(), 0);
  if (largest == 0) return marked;
  const double cut = share < 1 ? cut_that_holds(eta, share, largest, comm) : 0.0;
  for (std::size_t k = 0; k < eta.size(); ++k) marked[k] = eta[k] > 0 && eta[k] >= cut;
  return marked;
}

}  // namespace voussoir
