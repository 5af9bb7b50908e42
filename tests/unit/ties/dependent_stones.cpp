// What hangs on one stone alone, found in the graph of stones, on one rank and shared out.
#include "ties/dependent_stones.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <random>
#include <set>
#include <utility>

namespace {

using namespace voussoir;

/// Stones 0, 1, ... of which some stand on the ground and pairs hold each other.
struct Pile {
  int stones;
  std::set<std::pair<int, int>> joints;
  std::set<int> on_ground;

  /// As ranks find it that own the stones named, each by itself.
  std::vector<Dependence> found_by(const std::vector<int>& owner) const {
    const int ranks = 1 + *std::max_element(owner.begin(), owner.end());
    std::vector<OwnStones> parts;
    std::vector<HoldEachOther> at_borders;
    for (int rank = 0; rank < ranks; ++rank) {
      std::vector<BlockId> own;
      std::vector<HoldEachOther> pairs, across;
      for (int b = 0; b < stones; ++b)
        if (owner[b] == rank) own.push_back(b);
      for (const int b : on_ground)
        if (owner[b] == rank) pairs.push_back({the_ground, b});
      for (const auto& [a, b] : joints)
        if (owner[a] == rank || owner[b] == rank) (owner[a] == owner[b] ? pairs : across).push_back({a, b});
      parts.emplace_back(own, pairs, across);
      at_borders.insert(at_borders.end(), parts.back().at_borders().begin(), parts.back().at_borders().end());
    }
    const HeldStones known(at_borders);
    std::vector<Dependence> all;
    for (const auto& part : parts) {
      const auto more = part.dependences(known);
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }
  DependentStones alone() const { return DependentStones(found_by(std::vector<int>(stones, 0))); }

  /// Stones that are held when one is taken away, or all of them.
  std::set<int> held_without(int taken) const {
    std::set<int> held;
    std::vector<int> to_visit;
    for (const int b : on_ground)
      if (b != taken && held.insert(b).second) to_visit.push_back(b);
    while (!to_visit.empty()) {
      const int b = to_visit.back();
      to_visit.pop_back();
      for (const auto& [i, j] : joints)
        for (const auto& [from, to] : {std::make_pair(i, j), std::make_pair(j, i)})
          if (from == b && to != taken && held.insert(to).second) to_visit.push_back(to);
    }
    return held;
  }
  /// By taking every stone away: of the stones without which another is not held, the one which depends on all others.
  std::map<BlockId, BlockId> by_trial() const {
    std::map<int, std::set<int>> needs;
    const auto held = held_without(-1);
    for (const int taken : held) {
      const auto left = held_without(taken);
      for (const int b : held)
        if (b != taken && left.count(b) == 0) needs[b].insert(taken);
    }
    std::map<BlockId, BlockId> on;
    for (const auto& [stone, all] : needs)
      for (const int nearest : all)
        if (needs.count(nearest) ? needs.at(nearest).size() + 1 == all.size() : all.size() == 1) on[stone] = nearest;
    return on;
  }
};

std::vector<BlockSums> ones(const DependentStones& dependent) {
  return std::vector<BlockSums>(dependent.dependants().size(), BlockSums{1, 0, 0, 0, 0, 0});
}

// 0 stands on the ground, 1 on it, and a chain 2 - 3 - 4 hangs from 1.
TEUCHOS_UNIT_TEST(DependentStones, AChainDependsLinkByLink) {
  const auto dependent = Pile{5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {0}}.alone();
  TEST_EQUALITY(dependent.dependants().size(), std::size_t(4));
  const auto sums = dependent.sums(ones(dependent));
  TEST_EQUALITY(sums.at(0)[0], 4.0);
  TEST_EQUALITY(sums.at(1)[0], 3.0);
  TEST_EQUALITY(sums.at(3)[0], 1.0);
  TEST_EQUALITY(sums.count(4), std::size_t(0));
  TEST_EQUALITY(dependent.depends_on(4), 3);
}

// A ring between two supports: without any one stone the others still have a support each. 5 rides on the crown.
TEUCHOS_UNIT_TEST(DependentStones, NoVoussoirOfAnArchDependsOnAnother) {
  const auto dependent = Pile{6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {2, 5}}, {0, 4}}.alone();
  TEST_EQUALITY(dependent.dependants().size(), std::size_t(1));
  TEST_EQUALITY(dependent.depends_on(5), 2);
  TEST_EQUALITY(dependent.depends_on(2), -1);
}

// 1, 2, 3 go round on 0: none is cut off by another but all by 0; 4 on 3 is cut off by 3 and, with it, by 0.
TEUCHOS_UNIT_TEST(DependentStones, WhatGoesRoundDependsOnWhereItBegan) {
  const auto dependent = Pile{5, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}}, {0}}.alone();
  for (int b : {1, 2, 3}) TEST_EQUALITY(dependent.depends_on(b), 0);
  TEST_EQUALITY(dependent.depends_on(4), 3);
  const auto sums = dependent.sums(ones(dependent));
  TEST_EQUALITY(sums.at(0)[0], 4.0);
  TEST_EQUALITY(sums.at(3)[0], 1.0);
  TEST_EQUALITY(sums.count(1) + sums.count(2), std::size_t(0));
}

// Piles by lot, dense and thin, with stones that nothing holds, on one rank and dealt out among several.
TEUCHOS_UNIT_TEST(DependentStones, AreThoseThatATrialFindsHoweverStonesAreSharedOut) {
  int dependences = 0, rings = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 lot(seed);
    const auto below = [&](int n) { return static_cast<int>(lot() % static_cast<unsigned>(n)); };
    Pile pile{4 + below(14), {}, {}};
    for (int n = pile.stones * (2 + below(4)) / 3; n-- > 0;) {
      const int a = below(pile.stones), b = below(pile.stones);
      if (a != b) pile.joints.insert({std::min(a, b), std::max(a, b)});
    }
    for (int n = below(4); n-- > 0;) pile.on_ground.insert(below(pile.stones));
    const auto expected = pile.by_trial();
    for (const int ranks : {1, 2, 3, 5}) {
      std::vector<int> owner;
      for (int b = 0; b < pile.stones; ++b) owner.push_back(seed % 2 == 0 ? b * ranks / pile.stones : below(ranks));
      std::map<BlockId, BlockId> found;
      for (const auto& [stone, on] : pile.found_by(owner)) {
        TEST_ASSERT(found.emplace(stone, on).second);
      }
      TEST_ASSERT(found == expected);
    }
    dependences += static_cast<int>(expected.size());
    rings += static_cast<int>(pile.joints.size()) >= pile.stones;
  }
  TEST_COMPARE(dependences, >, 500);
  TEST_COMPARE(rings, >, 50);
}

// Ranks tell each other of stones at their borders alone: a wall of 12 courses of 12, its lower half on one of two.
TEUCHOS_UNIT_TEST(DependentStones, RanksHearOfBordersAlone) {
  constexpr int side = 12;
  std::vector<BlockId> own;
  std::vector<HoldEachOther> pairs, across;
  for (int b = 0; b < side * side / 2; ++b) {
    own.push_back(b);
    if (b < side) pairs.push_back({the_ground, b});
    if (b % side > 0) pairs.push_back({b - 1, b});
    (b + side < side * side / 2 ? pairs : across).push_back({b, b + side});
  }
  const OwnStones lower(own, pairs, across);
  // The joints across, and a ring of the stones below them and of the ground.
  TEST_EQUALITY(lower.at_borders().size(), std::size_t(side + side + 1));
}

}  // namespace
