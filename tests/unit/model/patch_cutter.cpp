// A stone that is out of balance is brought to rest with its neighbours, while the rest of the wall holds still.
#include "model/patch_cutter.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>

#include "linalg/local_view.hpp"
#include "linalg/reduce.hpp"
#include "mesh/generators.hpp"
#include "nonlinear/residuals.hpp"
#include "nonlinear/stuck_stones.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A wall of 9 courses of 9 stones at rest under its own weight, every point a contact point.
struct WallAtRest {
  Experiment wall;
  LinearSolver solver;
  std::unique_ptr<ContactProblem> problem;
  Teuchos::RCP<TpetraVector> x;
  PointField lambda;
  std::vector<PointStiffness> sticking;

  explicit WallAtRest(double largest_share = 1.0) : wall(scene(largest_share)), solver(wall.scene().solver) {
    if (!wall.advance({{"weight", 1}})) throw std::runtime_error("the wall does not stand");
    const auto& model = wall.model();
    const ContactState& state = wall.state();
    problem = std::make_unique<ContactProblem>(
        parts_of(model, solver), state.selected,
        ContactProblem::Asked{model.law(), state.slip_origin, wall.load(), wall.prescribed()});
    x = problem->unknowns(wall.state().displacement);
    lambda = wall.state().lambda;
    for (const double stiffness : model.local_stiffness()) sticking.push_back({stiffness, stiffness});
  }
  static Scene scene(double largest_share) {
    Scene scene = wall_scene(9);
    scene.mesh.wall.cells_along = 2;
    scene.mesh.wall.cells_up = 1;
    scene.internals.methods.patches.largest_share = largest_share;
    return scene;
  }
  /// Owned unknowns of the blocks for which `chosen` is true.
  std::set<int> unknowns_of(const std::function<bool(BlockId)>& chosen) const {
    const auto& s = wall.model().structure();
    const auto& space = problem->space();
    std::set<int> list;
    for (int i = 0; i < s.nodes(); ++i)
      if (space.cluster()[i] < space.owned_clusters() && chosen(s.blocks()[s.block_of_node()[i]].mesh.id))
        for (int c = 0; c < 2; ++c) list.insert(2 * space.cluster()[i] + c);
    return list;
  }
  void lift(BlockId block, double by) {
    for (const int i : unknowns_of([&](BlockId b) { return b == block; }))
      if (i % 2 == 1) local_view_to_write(*x)[i] += by;
  }
  /// [-] of the largest force: what is out of balance or against the law.
  double off() {
    TpetraVector residual(problem->map());
    PointField gap;
    problem->evaluate(*x, residual, gap);
    const Imbalance i = imbalance(*problem, CurrentLaws(*problem, {}, lambda, gap), lambda, gap, residual);
    return std::max(i.equilibrium, i.contact) / force_scale(*problem, lambda);
  }
  int correct(const TpetraVector& start) {
    const double scale = force_scale(*problem, lambda);
    auto& source = *problem->patches();
    source.part_no_more_together();
    return bring_to_rest(source, *problem->map()->getComm(), *x, lambda,
                         {1e-4 * scale, 1e-8, scale, 10 * scale, sticking, start}, wall.scene().internals.methods);
  }
};

constexpr BlockId middle = 42;  // fifth of the fifth course: 9 + 10 + 9 + 10 stones are below

TEUCHOS_UNIT_TEST(StuckStones, AWallAtRestIsLeftAlone) {
  WallAtRest w;
  const TpetraVector before(*w.x, Teuchos::Copy);
  TEST_COMPARE(w.off(), <, 1e-5);
  const int solves = w.correct(before);
  TEST_EQUALITY(solves, 0);
  w.x->update(-1.0, before, 1.0);
  TEST_EQUALITY(w.x->norm2(), 0.0);
}

// Lifted by 1e-7 m, ten times as far as the wall is pressed together there, a stone bears nothing and is borne by none.
TEUCHOS_UNIT_TEST(StuckStones, AStoneThatWasLiftedComesToRestWhereItWas) {
  WallAtRest w;
  const TpetraVector at_rest(*w.x, Teuchos::Copy);
  w.lift(middle, 1e-7);
  TEST_COMPARE(w.off(), >, 0.01);
  const int solves = w.correct(at_rest);
  TEST_COMPARE(solves, >, 0);
  // What patches pass on to those around them is less than was there.
  TEST_COMPARE(w.off(), <, 1e-3);
  w.x->update(-1.0, at_rest, 1.0);
  TEST_COMPARE(w.x->normInf(), <, 1e-9);
  // The lowest and the highest course are farther from it than a patch reaches.
  for (const int i : w.unknowns_of([](BlockId b) { return b < 9 || b >= 76; })) TEST_EQUALITY(local_view(*w.x)[i], 0.0);
}

TEUCHOS_UNIT_TEST(StuckStones, APatchThatIsTooLargeIsNotTried) {
  WallAtRest w(0.01);
  const TpetraVector at_rest(*w.x, Teuchos::Copy);
  w.lift(middle, 1e-7);
  const TpetraVector lifted(*w.x, Teuchos::Copy);
  const int solves = w.correct(at_rest);
  TEST_EQUALITY(solves, 0);
  w.x->update(-1.0, lifted, 1.0);
  TEST_EQUALITY(w.x->norm2(), 0.0);
}

/// The rank that owns most of the stones within two joints of one, or -1 where no rank owns three more than any other.
int owner_of_most(const WallAtRest& w, BlockId stone) {
  const auto source = make_wall(w.wall.scene().mesh.wall);
  const auto graph = graph_of(*source);
  const auto& s = w.wall.model().structure();
  std::vector<int> mine(s.total_blocks(), 0), owner(mine);
  for (int b = 0; b < s.owned_blocks(); ++b) mine[s.nodes_of(b).id] = s.comm()->getRank();
  Teuchos::reduceAll(*s.comm(), Teuchos::REDUCE_SUM, s.total_blocks(), mine.data(), owner.data());
  std::set<BlockId> near{stone};
  for (int ring = 0; ring < 2; ++ring)
    for (const BlockId b : std::set<BlockId>(near))
      for (int e = graph.start[b]; e < graph.start[b + 1]; ++e)
        if (graph.shared_vertices[e] > 1) near.insert(graph.neighbour[e]);
  std::vector<int> stones(w.wall.model().structure().comm()->getSize() + 1, 0);
  for (const BlockId b : near) ++stones[owner[b]];
  const auto most = std::max_element(stones.begin(), stones.end());
  const int rank = static_cast<int>(most - stones.begin());
  return std::count_if(stones.begin(), stones.end(), [&](int n) { return n + 3 > *most; }) == 1 ? rank : -1;
}

TEUCHOS_UNIT_TEST(StuckStones, APatchGoesToTheRankThatOwnsMostOfItsBlocksAlone) {
  WallAtRest w;
  const auto& comm = *w.problem->map()->getComm();
  const TpetraVector at_rest(*w.x, Teuchos::Copy);
  const double scale = force_scale(*w.problem, w.lambda);
  auto& source = *w.problem->patches();
  int clear = 0;
  for (BlockId stone = 20; stone < 66; stone += 5) {
    w.lift(stone, 1e-7);
    TEST_ASSERT(source.find_stuck(*w.x, w.lambda, 1e-4 * scale));
    TEST_ASSERT(source.group(false, 1.0));
    const auto cut = source.cut(*w.x, w.lambda, {1e-4 * scale, 1e-8, scale, 10 * scale, w.sticking, at_rest});
    w.lift(stone, -1e-7);
    TEST_EQUALITY(total_over_ranks(comm, static_cast<int>(cut.size())), 1);
    const int owner = owner_of_most(w, stone);
    if (owner < 0) continue;
    ++clear;
    TEST_EQUALITY(cut.empty(), comm.getRank() != owner);
  }
  TEST_COMPARE(clear, >=, 2);
}

TEUCHOS_UNIT_TEST(StuckStones, WhatIsMoreThanAShareOfAllIsNotGrouped) {
  WallAtRest w;
  w.lift(middle, 1e-7);
  const double scale = force_scale(*w.problem, w.lambda);
  auto& source = *w.problem->patches();
  TEST_ASSERT(source.find_stuck(*w.x, w.lambda, 1e-4 * scale));
  TEST_ASSERT(!source.group(true, 0.5));
  TEST_ASSERT(source.group(true, 1.0));
  TEST_ASSERT(source.group(false, 0.4));
  TEST_ASSERT(!source.group(false, 0.1));
}

}  // namespace
