// Reactions of supports that hold one stone between them, against balance by hand, in the plane and in space.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "unit/statics/structures.hpp"
#include "unit/statics/structures_in_space.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double close = 1e-8;

template <int dim>
using Supports = std::vector<RigidSupport<dim>>;

/// Every order in which supports may be written; their names stay.
template <int dim, class Check>
void in_any_order(RigidStructure<dim> s, const std::vector<Supports<dim>>& supports, const Check& check) {
  std::vector<std::size_t> order(supports.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  do {
    s.supports.clear();
    for (const auto k : order) s.supports.insert(s.supports.end(), supports[k].begin(), supports[k].end());
    check(LimitAnalysis<dim>(s));
  } while (std::next_permutation(order.begin(), order.end()));
}

bool is(const ReactionRange& range, double force) {
  return range.least && range.most && std::abs(*range.least - force) < close && std::abs(*range.most - force) < close;
}

template <int dim>
bool are(const std::array<ReactionRange, dim>& ranges, const Vector<dim>& force) {
  for (std::size_t c = 0; c < dim; ++c)
    if (!is(ranges[c], force[c])) return false;
  return true;
}

bool endless_both_ways(const ReactionRange& range) { return !range.least && !range.most; }

Vector<2> turned(const Vector<2>& v, double angle) {
  return {v[0] * std::cos(angle) - v[1] * std::sin(angle), v[0] * std::sin(angle) + v[1] * std::cos(angle)};
}

/// What holds the nodes of a side between two places of a stone about its middle along directions.
Supports<2> side(int name, const Vector<2>& a, const Vector<2>& b, const std::vector<Vector<2>>& directions) {
  Supports<2> nodes;
  for (int k = 0; k <= 4; ++k)
    for (const auto& d : directions) nodes.push_back({0, a + (k / 4.0) * (b - a), d, name});
  return nodes;
}

// A box of 1 x 0.5 and weight 1, loaded off its middle, hung by its sides: the lever says what each bears.
TEUCHOS_UNIT_TEST(SharedStones, ABeamBetweenTwoSidesDrawnAtAnyAngle) {
  for (const double angle : {0.0, 0.4, 2.0}) {
    const auto at = [&](double x, double y) { return turned({x, y}, angle); };
    RigidStructure<2> s;
    add_box(s, {0, 0}, 1, 0.5, 0);
    const auto down = at(0, -1), push = at(0.03, -0.1);
    const double moment = cross(at(-0.25, 0.25), push);
    s.stones[0].fixed = {down[0] + push[0], down[1] + push[1], moment};
    const std::vector<Supports<2>> supports{side(0, at(-0.5, -0.25), at(-0.5, 0.25), {at(0, 1)}),
                                            side(1, at(0.5, -0.25), at(0.5, 0.25), {at(0, 1)}),
                                            side(2, at(-0.5, -0.25), at(0.5, -0.25), {at(1, 0)})};
    // Along the foot -0.03, 0.25 below the middle; both sides 1.1 together, and their difference by the moments.
    const double of_sides = -moment + 0.03 * 0.25;
    in_any_order<2>(s, supports, [&](const LimitAnalysis<2>& analysis) {
      const auto found = analysis.reactions(3, 0);
      TEST_ASSERT(are<2>(found[0], at(0, 0.55 - of_sides)));
      TEST_ASSERT(are<2>(found[1], at(0, 0.55 + of_sides)));
      TEST_ASSERT(are<2>(found[2], at(-0.03, 0)));
    });
  }
}

TEUCHOS_UNIT_TEST(SharedStones, WhatTwoSupportsHoldHasNoEndAndTheRestHas) {
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 0.5, 1);
  const Vector<2> x{1, 0}, y{0, 1};
  const auto left = side(0, {-0.5, -0.25}, {-0.5, 0.25}, {x, y}), right = side(1, {0.5, -0.25}, {0.5, 0.25}, {x, y});
  in_any_order<2>(s, {left, right}, [&](const LimitAnalysis<2>& analysis) {
    for (const auto& of : analysis.reactions(2, 0))
      for (const auto& range : of) TEST_ASSERT(endless_both_ways(range));
  });
  // The right side on rollers: it presses up or down as one likes, since the left holds turns, and never along x.
  const auto rollers = side(1, {0.5, -0.25}, {0.5, 0.25}, {y});
  in_any_order<2>(s, {left, rollers}, [&](const LimitAnalysis<2>& analysis) {
    const auto found = analysis.reactions(2, 0);
    TEST_ASSERT(is(found[0][0], 0) && is(found[1][0], 0));
    TEST_ASSERT(endless_both_ways(found[0][1]) && endless_both_ways(found[1][1]));
  });
}

TEUCHOS_UNIT_TEST(SharedStones, NodesOfTwoSupportsBelongToBoth) {
  // A foot and a side share a corner: what one holds of it the other may bear.
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 1, 1);
  for (const auto& d : {Vector<2>{1, 0}, Vector<2>{0, 1}}) s.supports.push_back({0, {-0.5, -0.5}, d, 0});
  s.supports.push_back({0, {0.5, -0.5}, {0, 1}, 1});
  TEST_ASSERT(are<2>(LimitAnalysis(s).reactions(2, 0)[0], {0, 0.5}));
  s.held_again.push_back({0, {-0.5, -0.5}, {1, 0}, 1});
  const auto found = LimitAnalysis(s).reactions(2, 0);
  for (const auto& of : found) TEST_ASSERT(endless_both_ways(of[0]) && is(of[1], 0.5));
  TEST_ASSERT(LimitAnalysis(s).bears(0).verdict == LimitVerdict::unlimited);
}

TEUCHOS_UNIT_TEST(SharedStones, SidesThatAreOffTheirPlanesByTheDigitsOfADrawingHoldNoTurns) {
  RigidStructure<2> s;
  add_box(s, {0, 0}, 1, 0.5, 1);
  s.stones[0].fixed[2] = 0.1;
  const double off = 1e-6;
  for (int k = 0; k < 5; ++k)
    for (const double at : {-0.5, 0.5})
      s.supports.push_back({0, {at + off * (k % 3 - 1), k / 8.0 - 0.25}, {0, 1}, at < 0 ? 0 : 1});
  s.supports.push_back({0, {0, -0.25}, {1, 0}, 2});
  const auto found = LimitAnalysis(s).reactions(3, 0);
  for (const auto& [support, force] : {std::make_pair(0, 0.6), {1, 0.4}}) {
    const auto& range = found[static_cast<std::size_t>(support)][1];
    TEST_COMPARE(std::abs(range.least.value_or(9) - force), <, 1e-5);
    TEST_COMPARE(std::abs(range.most.value_or(9) - force), <, 1e-5);
  }
}

// A wedge between two inclined planes and against a third across both.
TEUCHOS_UNIT_TEST(SharedStones, AWedgeBetweenTwoPlanesBearsOnTheirNormals) {
  for (const auto& [alpha, beta] : {std::make_pair(0.4, 0.7), {0.2, 1.1}}) {
    RigidStructure<3> s;
    s.stones.push_back({{}, 1, {0, 0, -1, 0, 0, 0}, {}});
    const Vector<3> a{std::cos(alpha), 0, std::sin(alpha)}, b{-std::cos(beta), 0, std::sin(beta)};
    const Vector<3> along_a{-a[2], 0, a[0]}, along_b{b[2], 0, -b[0]}, y{0, 1, 0};
    std::vector<Supports<3>> supports(3);
    for (const double u : {-0.4, 0.0, 0.4})
      for (const double v : {-0.3, 0.2}) {
        supports[0].push_back({0, -0.5 * a + u * along_a + v * y, a, 0});
        supports[1].push_back({0, -0.5 * b + u * along_b + v * y, b, 1});
        supports[2].push_back({0, {u, -0.3, v}, y, 2});
      }
    // na cos(alpha) = nb cos(beta), na sin(alpha) + nb sin(beta) = 1.
    const double of_a = std::cos(beta) / std::sin(alpha + beta), of_b = std::cos(alpha) / std::sin(alpha + beta);
    in_any_order<3>(s, supports, [&, of_a, of_b](const LimitAnalysis<3>& analysis) {
      const auto found = analysis.reactions(3, 0);
      TEST_ASSERT(are<3>(found[0], of_a * a));
      TEST_ASSERT(are<3>(found[1], of_b * b));
      TEST_ASSERT(are<3>(found[2], {}));
    });
  }
}

TEUCHOS_UNIT_TEST(SharedStones, InSpaceASideHeldWholeBesideAFootHeldUpwards) {
  RigidStructure<3> s;
  add_box(s, {0, 0, 0}, {1, 1, 1});
  std::vector<Supports<3>> supports(2);
  for (const double u : {-0.5, 0.5})
    for (const double v : {-0.5, 0.5}) {
      for (std::size_t c = 0; c < 3; ++c) {
        Vector<3> axis{};
        axis[c] = 1;
        supports[0].push_back({0, {-0.5, u, v}, axis, 0});
      }
      supports[1].push_back({0, {u, v, -0.5}, {0, 0, 1}, 1});
    }
  in_any_order<3>(s, supports, [&](const LimitAnalysis<3>& analysis) {
    const auto found = analysis.reactions(2, 0);
    for (const auto& of : found) TEST_ASSERT(is(of[0], 0) && is(of[1], 0) && endless_both_ways(of[2]));
  });
}

TEUCHOS_UNIT_TEST(SharedStones, TheBedsOfAnArchAreHeldByTwoSupportsEach) {
  // Half of each springing is held upwards and half sideways: thrust goes to these, as to one support that holds both.
  auto s = ring(7, 10, 1.5, pi, {0.6});
  const auto whole = LimitAnalysis(s).reactions(2, 0);
  for (auto& support : s.supports)
    if (support.direction[1] > 0.5) support.name += 2;
  const auto parts = LimitAnalysis(s).reactions(4, 0);
  for (std::size_t k = 0; k < 2; ++k) {
    TEST_FLOATING_EQUALITY(parts[k][0].least.value_or(-9), whole[k][0].least.value_or(9), 1e-7);
    TEST_FLOATING_EQUALITY(parts[k][0].most.value_or(-9), whole[k][0].most.value_or(9), 1e-7);
    TEST_FLOATING_EQUALITY(parts[k + 2][1].most.value_or(-9), whole[k][1].most.value_or(9), 1e-7);
    TEST_ASSERT(is(parts[k][1], 0) && is(parts[k + 2][0], 0));
  }
}

}  // namespace
