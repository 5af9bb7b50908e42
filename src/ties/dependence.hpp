// Which stones would be cut off from every support without one other, where each rank knows its own stones alone.
//
// Seen from the supports, which count as one thing, the graph of stones falls into parts in which nothing hangs on one
// stone alone (biconnected components), joined at stones that do cut something off. A rank finds the parts of its own
// stones. A part that touches other ranks, supports or other parts in several places it hands on as a ring of these
// places, which hangs together as the part does, without any one of them; what is left hangs on one stone and is known
// at once. So ranks tell each other of stones at their borders, not of those within.
#pragma once

#include <utility>
#include <vector>

#include "base/ids.hpp"

namespace voussoir {

/// The supports, as a stone.
constexpr BlockId the_ground = -1;

/// Two stones of which each holds the other, or a stone and the ground.
struct HoldEachOther {
  BlockId a, b;
};

/// A stone that would be cut off from every support without another, the nearest such.
struct Dependence {
  BlockId stone, on;
};

/// Which of the stones in a graph are held, and on which one each depends; from the ground on.
class HeldStones {
 public:
  /// @param pairs  in any order, repeated or not
  explicit HeldStones(const std::vector<HoldEachOther>& pairs);
  bool holds(BlockId) const;
  /// The ground for what depends on no stone, and for what is not held.
  BlockId depends_on(BlockId) const;

 private:
  int place(BlockId) const;
  std::vector<BlockId> stone_;  ///< ascending
  std::vector<char> held_;
  std::vector<BlockId> on_;
};

/// The stones of one rank.
class OwnStones {
 public:
  /// @param stones  of this rank, ascending
  /// @param pairs   of these with each other and with the ground
  /// @param across  with stones of other ranks; both ranks name them
  OwnStones(std::vector<BlockId> stones, const std::vector<HoldEachOther>& pairs,
            const std::vector<HoldEachOther>& across);

  /// What others are to know: pairs of stones at borders, among them those that stand for what lies between.
  const std::vector<HoldEachOther>& at_borders() const { return at_borders_; }
  /// @param known  of what all ranks have at borders
  std::vector<Dependence> dependences(const HeldStones& known) const;

 private:
  /// Stones none of which is cut off from the others by one of them.
  struct Part {
    std::vector<int> members;  ///< numbers of stones here; 0 is the ground
    std::vector<int>
        meets_others;  ///< of these, what others touch: for a part that hangs on one stone that one or none
  };
  void find_parts(const std::vector<std::vector<int>>& beside);
  static std::vector<int> touched(const Part&, const std::vector<char>& border, const std::vector<int>& left);
  void strip_hanging(const std::vector<char>& border);
  BlockId hangs_on(const Part&, const std::vector<BlockId>& on) const;

  std::vector<BlockId> stone_;  ///< by number here; the ground first
  std::vector<Part> between_;   ///< parts that meet others in several places
  std::vector<Part> hanging_;   ///< in an order in which each comes before the one it hangs on
  std::vector<HoldEachOther> at_borders_;
};

}  // namespace voussoir
