// Stones that depend on one other: all that would be cut off from every support if that stone were not there.
//
// What a stone and its dependants carry is known by statics alone, whatever is elastic: all of it passes through that
// stone's joints with the others. So a chain that hangs, a stack that slides, a post that tips is judged as one.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "base/ids.hpp"
#include "ties/dependence.hpp"

namespace voussoir {

/// Sums over blocks: forces and moments about one point, of what they lack and of their loads. In the plane the first
/// half is enough.
using BlockSums = std::array<double, 12>;

/// The dependants of blocks, each chain of dependence as a tree.
class DependentStones {
 public:
  /// @param all  of all ranks, in any order
  explicit DependentStones(const std::vector<Dependence>& all);

  /// Blocks that depend on another one, ascending.
  const std::vector<BlockId>& dependants() const { return dependants_; }
  /// The nearest block without which another would be cut off; -1 for those that depend on none.
  BlockId depends_on(BlockId b) const {
    const auto at = on_.find(b);
    return at == on_.end() ? -1 : at->second;
  }
  /// Sums over all dependants, direct and indirect, of every block that has some.
  /// @param own  of each of dependants()
  std::map<BlockId, BlockSums> sums(std::vector<BlockSums> own) const;

 private:
  std::vector<BlockId> dependants_;
  std::map<BlockId, BlockId> on_;  ///< the nearest block without which a dependant would be cut off
  std::vector<BlockId> leaves_first_;
};

}  // namespace voussoir
