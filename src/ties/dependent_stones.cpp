#include "ties/dependent_stones.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace voussoir {

// In the order of how many stones they hang on, one by one, so that leaves come first whatever ranks they are on.
DependentStones::DependentStones(const std::vector<Dependence>& all) {
  for (const auto& [stone, on] : all) on_[stone] = on;
  std::map<BlockId, int> hangs_on;  // how many
  std::vector<BlockId> way;
  for (const auto& [stone, on] : on_) {
    dependants_.push_back(stone);
    for (BlockId b = stone; on_.count(b) && !hangs_on.count(b); b = on_.at(b)) way.push_back(b);
    for (; !way.empty(); way.pop_back()) {
      const auto below = hangs_on.find(on_.at(way.back()));
      hangs_on[way.back()] = below == hangs_on.end() ? 1 : below->second + 1;
    }
  }
  leaves_first_ = dependants_;
  std::stable_sort(leaves_first_.begin(), leaves_first_.end(),
                   [&](BlockId a, BlockId b) { return hangs_on.at(a) > hangs_on.at(b); });
}

std::map<BlockId, BlockSums> DependentStones::sums(std::vector<BlockSums> own) const {
  VOUSSOIR_EXPECT(own.size() == dependants_.size() && "sums: of each that depends on another");
  std::map<BlockId, BlockSums> of;  // of all dependants of a block
  for (const BlockId b : leaves_first_) {
    const auto at = std::lower_bound(dependants_.begin(), dependants_.end(), b) - dependants_.begin();
    auto whole = own[at];
    if (const auto below = of.find(b); below != of.end())
      for (int c = 0; c < 6; ++c) whole[c] += below->second[c];
    auto& sum = of[on_.at(b)];
    for (int c = 0; c < 6; ++c) sum[c] += whole[c];
  }
  return of;
}

}  // namespace voussoir
