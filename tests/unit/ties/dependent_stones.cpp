// What hangs on one stone alone, found in the graph of blocks.
#include "ties/dependent_stones.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <set>
#include <utility>

namespace {

using namespace voussoir;

/// Blocks that share a joint, pair by pair.
BlockGraph graph_of(int blocks, const std::set<std::pair<int, int>>& joints, int shared = 2) {
  BlockGraph graph;
  for (int b = 0; b < blocks; ++b) {
    graph.start.push_back(static_cast<int>(graph.neighbour.size()));
    for (int other = 0; other < blocks; ++other) {
      if (joints.count({b, other}) + joints.count({other, b}) == 0) continue;
      graph.neighbour.push_back(other);
      graph.shared_vertices.push_back(shared);
    }
  }
  graph.start.push_back(static_cast<int>(graph.neighbour.size()));
  return graph;
}

std::vector<BlockSums> ones(const DependentStones& dependent) {
  return std::vector<BlockSums>(dependent.dependants().size(), BlockSums{1, 0, 0, 0, 0, 0});
}

// 0 stands on the ground, 1 on it, and a chain 2 - 3 - 4 hangs from 1.
TEUCHOS_UNIT_TEST(DependentStones, AChainDependsLinkByLink) {
  const DependentStones dependent(graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}), {1, 0, 0, 0, 0}, {});
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
  const DependentStones dependent(graph_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {2, 5}}), {1, 0, 0, 0, 1, 0}, {});
  TEST_EQUALITY(dependent.dependants().size(), std::size_t(1));
  TEST_EQUALITY(dependent.depends_on(5), 2);
  TEST_EQUALITY(dependent.depends_on(2), -1);
}

// 1, 2, 3 go round on 0: none is cut off by another but all by 0; 4 on 3 is cut off by 3 and, with it, by 0.
TEUCHOS_UNIT_TEST(DependentStones, WhatGoesRoundDependsOnWhereItBegan) {
  const DependentStones dependent(graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}}), {1, 0, 0, 0, 0}, {});
  for (int b : {1, 2, 3}) TEST_EQUALITY(dependent.depends_on(b), 0);
  TEST_EQUALITY(dependent.depends_on(4), 3);
  const auto sums = dependent.sums(ones(dependent));
  TEST_EQUALITY(sums.at(0)[0], 4.0);
  TEST_EQUALITY(sums.at(3)[0], 1.0);
  TEST_EQUALITY(sums.count(1) + sums.count(2), std::size_t(0));
}

// A prop that is not there holds nothing; stones that touch in one vertex have no joint.
TEUCHOS_UNIT_TEST(DependentStones, NeitherAbsentStonesNorCornersHold) {
  const auto propped = graph_of(3, {{0, 1}, {1, 2}});
  TEST_EQUALITY(DependentStones(propped, {1, 0, 1}, {}).dependants().size(), std::size_t(0));
  TEST_EQUALITY(DependentStones(propped, {1, 0, 1}, {0, 0, 1}).depends_on(1), 0);
  TEST_EQUALITY(DependentStones(graph_of(2, {{0, 1}}, 1), {1, 0}, {}).dependants().size(), std::size_t(0));
}

// In space two shared vertices are an edge, along which a stone can turn away, and three a joint.
TEUCHOS_UNIT_TEST(DependentStones, AnEdgeHoldsNoStoneInSpace) {
  TEST_EQUALITY(DependentStones(graph_of(2, {{0, 1}}, 2), {1, 0}, {}, 3).dependants().size(), std::size_t(0));
  TEST_EQUALITY(DependentStones(graph_of(2, {{0, 1}}, 3), {1, 0}, {}, 3).depends_on(1), 0);
}

}  // namespace
