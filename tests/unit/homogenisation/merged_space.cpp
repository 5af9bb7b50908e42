// Which node copies share an unknown, and the maps between unknowns and node copies.
#include "homogenisation/merged_space.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <set>

#include "unit/homogenisation/selected_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr Selected selections[] = {Selected::none, Selected::some, Selected::all};

TEUCHOS_UNIT_TEST(MergedSpace, HasOneNodePerVertexWithNothingSelectedAndOnePerCopyWithAllSelected) {
  const SelectedWall bonded(Selected::none), free(Selected::all);
  // 3 blocks of 4 x 2 cells in 5 courses: a lattice of 13 x 11 nodes.
  TEST_EQUALITY_CONST(bonded.space.map()->getGlobalNumElements(), 2 * 13 * 11);
  TEST_EQUALITY(free.space.map()->getGlobalNumElements(), Tpetra::global_size_t(2 * free.structure.total_nodes()));
}

TEUCHOS_UNIT_TEST(MergedSpace, TiesExactlyTheCopiesThatBondedPointsJoin) {
  const SelectedWall w(Selected::some);
  const auto& cluster = w.space.cluster();
  // Copies of one vertex belong together when a chain of bonded points leads from one to the other.
  const auto& start = w.structure.copies_start();
  for (std::size_t g = 0; g + 1 < start.size(); ++g) {
    const std::vector<int> copies(&w.structure.copy()[start[g]], &w.structure.copy()[start[g + 1] - 1] + 1);
    std::set<int> joined{copies.front()};
    for (std::size_t round = 0; round < copies.size(); ++round)
      for (int k = 0; k < w.points.size(); ++k) {
        const auto& p = w.points.points()[k];
        const int i = p.shares_i.first(), j = p.shares_j.first();
        if (!w.selected[k] && joined.count(i) + joined.count(j) == 1) joined.insert({i, j});
      }
    for (int copy : copies) TEST_EQUALITY(cluster[copy] == cluster[copies.front()], joined.count(copy) == 1);
  }
}

TEUCHOS_UNIT_TEST(MergedSpace, CountsEveryNodeCopyOnce) {
  for (const auto selected : selections) {
    const SelectedWall w(selected);
    double mine = 0;
    for (int k = 0; k < w.space.owned_clusters(); ++k) mine += w.space.multiplicity()[k];
    TEST_EQUALITY(sum_over_ranks(*everyone(), mine), double(w.structure.total_nodes()));
  }
}

TEUCHOS_UNIT_TEST(MergedSpace, GivesBackUnknownsThatItHasSpreadOut) {
  for (const auto selected : selections) {
    const SelectedWall w(selected);
    const auto x = noise_vector(w.space.map());
    TpetraVector back(w.space.map());
    std::vector<double> u;
    w.space.scatter(*x, u);
    w.space.average(u, back);
    back.update(-1.0, *x, 1.0);
    TEST_COMPARE(back.normInf(), <=, 1e-15);  // a mean of at most 3 equal numbers below 1
  }
}

TEUCHOS_UNIT_TEST(MergedSpace, SumsWithTheTransposeOfTheMapThatSpreads) {
  for (const auto selected : selections) {
    const SelectedWall w(selected);
    auto x = noise_vector(w.space.map());
    for (int k = 0; k < 2 * w.space.owned_clusters(); ++k)
      if (w.space.held()[k]) local_view_to_write(*x)[k] = 0;  // sums leave held rows out
    std::vector<double> u, r;
    w.space.scatter(*x, u);
    for (int i = 0; i < w.structure.nodes(); ++i)
      for (int c = 0; c < 2; ++c) r.push_back(noise(5 * w.structure.node_id()[i] + c));
    double work = 0;
    for (int i = 0; i < 2 * w.structure.owned_nodes(); ++i) work += u[i] * r[i];
    TpetraVector sum(w.space.map());
    w.space.sum(r, sum);
    // Some 700 products of size 1: round-off stays far below 1e-10.
    TEST_FLOATING_EQUALITY(sum.dot(*x), sum_over_ranks(*everyone(), work), 1e-10);
  }
}

TEUCHOS_UNIT_TEST(MergedSpace, HoldsAClusterWhenAnyOfItsCopiesIsHeldAndTakesTheHeldValue) {
  for (const auto selected : selections) {
    const SelectedWall w(selected);
    std::vector<double> u(2 * w.structure.nodes(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = w.held[i] ? 5.0 : 1.0;
    TpetraVector x(w.space.map());
    w.space.average(u, x);
    for (int i = 0; i < w.structure.nodes(); ++i) {
      const int k = w.space.cluster()[i];
      for (int c = 0; c < 2; ++c) {
        if (w.held[2 * i + c]) TEST_ASSERT(w.space.held()[2 * k + c]);
        if (k >= w.space.owned_clusters()) continue;
        TEST_FLOATING_EQUALITY(local_view(x)[2 * k + c], w.space.held()[2 * k + c] ? 5.0 : 1.0, 1e-15);
      }
    }
  }
}

}  // namespace
