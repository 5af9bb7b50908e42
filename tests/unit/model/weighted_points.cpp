// Joints along which meshes do not match: a uniform pressure passes them exactly, on any number of ranks, wherever a
// stone has slid to.
#include <Teuchos_UnitTestHarness.hpp>

#include "model/carried_points.hpp"
#include "unit/model/weighted_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double passes = 1e-10;

/// A stone's cells on another's do not match; nor do those of four.
std::vector<std::vector<Stone>> stacks() {
  const Stone first{0, 2, 0, 1, 3, 2}, second{0, 2, 1, 2, 5, 2}, third{0, 2, 2, 3, 2, 1}, fourth{0, 2, 3, 4, 4, 3};
  return {{first, second}, {first, second, third, fourth}};
}

TEUCHOS_UNIT_TEST(WeightedPoints, AUniformPressurePassesFromMeshToMesh) {
  for (const auto& stack : stacks())
    for (const double friction : {0.0, 0.6}) {
      PressedStones stones(stack);
      const auto report = stones.solve(friction);
      TEST_ASSERT(report.outcome == NewtonOutcome::converged);
      TEST_COMPARE(stones.off(), <=, passes);
      TEST_COMPARE(stones.tractions_off(), <=, passes);
      out << stack.size() << " stones, friction " << friction << ": " << report.newton_iterations << " solves, off by "
          << stones.off() << " and " << stones.tractions_off() << "\n";
    }
}

TEUCHOS_UNIT_TEST(WeightedPoints, AUniformPressurePassesWhereverAStoneHasSlidToOverCellsOfAnother) {
  for (const double by : {0.0, 0.125, 0.31, 0.5, 0.77})  // m; cells of the slab are 0.5 m long, of the stone 0.6 m
    for (const double friction : {0.0, 0.6}) {
      PressedStones stones({{0, 4, 0, 1, 8, 2}, {1 + by, 2.8 + by, 1, 2, 3, 2}});
      const auto report = stones.solve(friction);
      TEST_ASSERT(report.outcome == NewtonOutcome::converged);
      TEST_COMPARE(stones.off(), <=, passes);
      TEST_COMPARE(stones.tractions_off(), <=, passes);
    }
}

// Two stones side by side whose joint is tied, and one across that joint: the tied unknowns are at the ends of two
// joints with weights. Nodes beside the tie have points of both joints, so forces there are not unique; motions are.
TEUCHOS_UNIT_TEST(WeightedPoints, StandBesideTiesThatHoldTheStonesBelow) {
  for (const double friction : {0.0, 0.6}) {
    PressedStones stones({{0, 1, 0, 1, 2, 2}, {1, 3, 0, 1, 3, 2}, {0, 3, 1, 2, 7, 2}});
    // The second stone is held by its tie, not at its left end.
    for (std::size_t i = 0; i < stones.held.size(); i += 2)
      stones.held[i] = stones.structure.position()[i / 2][0] < 1e-12;
    long long tied = 0;
    for (int k = 0; k < stones.points.owned(); ++k) tied += !stones.selected[k];
    TEST_EQUALITY(sum_over_ranks(*everyone(), tied), 3 + 2);  // of the joint that matches, and the ends of the others
    const auto report = stones.solve(friction);
    TEST_ASSERT(report.outcome == NewtonOutcome::converged);
    TEST_COMPARE(stones.off(), <=, passes);
  }
}

// At the ends of the joint nodes coincide, and bear what is theirs alone.
TEUCHOS_UNIT_TEST(WeightedPoints, AreNeverTiedButWhereTheyArePairsOfCoincidentNodes) {
  const PressedStones stones(stacks().front());
  TEST_EQUALITY(stones.points.total(), 6);  // of the stone with five edges
  const auto is_end = [](const ContactPoint& p) { return p.place[0] == 0 || p.place[0] == 2; };
  for (const auto& p : stones.points.points()) TEST_EQUALITY(p.can_be_tied(), is_end(p));
  const Continuum continuum(stones.structure, stones.points, stones.held, {}, {}, stones.stiffness);
  for (const auto& p : stones.points.points()) TEST_EQUALITY(continuum.space().tied(p), is_end(p));
}

// A stone has slid over nodes of the slab: points have come and gone, and those that stay reach other nodes of it. What
// is carried over sticks where it is, without a shear of its own.
TEUCHOS_UNIT_TEST(CarriedPoints, StandWhereTheyStoodOrBeginWithoutAPast) {
  const std::vector<Stone> drawn{{0, 4, 0, 1, 8, 2}, {0.9, 2.7, 1, 2, 3, 2}};
  PressedStones before(drawn), after(drawn, 0.77);
  TEST_ASSERT(before.solve(0.6).outcome == NewtonOutcome::converged);
  ContactState state;
  state.displacement = before.displacement;
  for (int n = 0; n < before.structure.nodes(); ++n)
    for (int c = 0; c < 2; ++c) state.displacement[2 * n + c] += after.exact(n)[c] - before.exact(n)[c];
  state.lambda = before.lambda;
  state.slip_origin = state.lambda;
  for (int k = 0; k < before.points.size(); ++k) {
    state.slip_origin[2 * k] = 0;
    state.slip_origin[2 * k + 1] = before.points.at(k).motion(state.displacement)[1];
  }
  state.selected = before.selected;
  state.status.assign(before.points.size(), static_cast<char>(PointStatus::stick));
  const auto same =
      same_places(places_of(after.points, after.structure), places_of(before.points, before.structure), 1e-9);
  const auto stand = std::count_if(same.begin(), same.begin() + after.points.owned(), [](int k) { return k >= 0; });
  TEST_EQUALITY(sum_over_ranks<long long>(*everyone(), stand), 4);  // of six points, and of five
  carry_points(before.points, after.points, same, state);
  TEST_EQUALITY(state.lambda.size(), 2 * same.size());
  TEST_EQUALITY(state.selected.size(), same.size());
  TEST_ASSERT(state.opened.empty() && state.rest.steps.empty());  // none before, none after
  for (std::size_t k = 0; k < same.size(); ++k) {
    TEST_EQUALITY(state.lambda[2 * k], same[k] < 0 ? 0.0 : before.lambda[2 * same[k]]);
    TEST_EQUALITY(state.status[k], static_cast<char>(same[k] < 0 ? PointStatus::open : PointStatus::stick));
    const double slip = after.points.at(static_cast<int>(k)).motion(state.displacement)[1];
    TEST_COMPARE(std::abs(state.slip_origin[2 * k + 1] - slip), <=, 1e-15);
  }
  after.displacement = state.displacement;
  after.lambda = state.lambda;
  after.slip_origin = state.slip_origin;
  TEST_ASSERT(after.solve(0.6).outcome == NewtonOutcome::converged);
  TEST_COMPARE(after.off(), <=, passes);
  TEST_COMPARE(after.tractions_off(), <=, 1e4 * passes);  // displacements are 1e4 times those that make them
}

// Where a point reaches two nodes of one stone, their stiffness is not lost with the point's.
TEUCHOS_UNIT_TEST(WeightedPoints, ComeAndGoFromTheSystemAsIfTheyHadNeverBeen) {
  const PressedStones stones(stacks().back());
  const MergedSpace space(stones.structure, stones.points, stones.selected, stones.held);
  SystemMatrix system(stones.structure, stones.points, stones.selected, space);
  const auto values = [&] {
    const auto h = system.local();
    return std::vector<double>(h.value, h.value + h.start[2 * space.owned_clusters()]);
  };
  const auto before = values();
  std::vector<PointStiffness> stiffness(stones.points.size());
  system.update(stiffness, {});
  TEST_ASSERT(values() == before);
  for (auto& s : stiffness) s = {young, young / 2, young / 3};
  system.update(stiffness, {});
  TEST_ASSERT(system.couple(stiffness));
  if (stones.points.size() > 0) TEST_ASSERT(values() != before);
  system.update(std::vector<PointStiffness>(stones.points.size()), {});
  TEST_ASSERT(values() == before);
}

TEUCHOS_UNIT_TEST(WeightedPoints, ForcesAndMotionsAreOneOperatorAndItsTranspose) {
  const PressedStones stones(stacks().back(), 0, alone());
  std::vector<double> u(stones.held.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = noise(static_cast<long long>(i));
  for (int k = 0; k < stones.points.size(); ++k) {
    const double force[] = {noise(3 * k), noise(3 * k + 1)};
    std::vector<double> nodal(u.size(), 0.0);
    stones.points.at(k).add_forces(force, 1.0, nodal);
    const auto motion = stones.points.at(k).motion(u);
    double work = 0;
    for (std::size_t i = 0; i < u.size(); ++i) work += u[i] * nodal[i];
    TEST_COMPARE(std::abs(work - force[0] * motion[0] - force[1] * motion[1]), <=, 1e-14);
  }
}

}  // namespace
