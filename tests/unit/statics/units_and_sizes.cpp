// Limits do not know units, origins, or how much a stone weighs beside others.
#include <Teuchos_UnitTestHarness.hpp>
#include <random>

#include "unit/statics/structures.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double most = 100;

/// The same structure in other units of length and force.
RigidStructure<2> in_units(RigidStructure<2> s, double length, double force) {
  for (auto& stone : s.stones) {
    stone.middle = length * stone.middle;
    stone.radius *= length;
    for (auto* w : {&stone.fixed, &stone.raised}) *w = {force * (*w)[0], force * (*w)[1], force * length * (*w)[2]};
  }
  for (auto& c : s.contacts) {
    c.arm_i = length * c.arm_i;
    c.arm_j = length * c.arm_j;
    c.law.cohesion *= force;
    c.law.tension *= force;
  }
  for (auto& support : s.supports) support.arm = length * support.arm;
  return s;
}

TEUCHOS_UNIT_TEST(Units, FactorsAreTheSameInAllOfThem) {
  auto bonded = box_on_bed(0.4, 1, {0.3, 0.25, 0.05});
  for (const auto& s : {ring(9, 5, 0.8, 2.5, {0.7}), wall({{2, 2}, {1, 2, 1}, {2, 2}}, 0.65), bonded}) {
    const auto here = LimitAnalysis(s).largest_factor(most);
    TEST_ASSERT(here.verdict == LimitVerdict::limited);
    for (const double length : {1e-3, 1.0, 1e3, 1e6})
      for (const double force : {1e-6, 1.0, 1e9}) {
        const LimitAnalysis analysis(in_units(s, length, force));
        const auto there = analysis.largest_factor(most);
        TEST_ASSERT(there.verdict == LimitVerdict::limited);
        TEST_FLOATING_EQUALITY(there.factor, here.factor, 1e-9);
        TEST_ASSERT(analysis.bears(1.001 * here.factor).verdict == LimitVerdict::refused);
        TEST_ASSERT(analysis.bears(0.999 * here.factor).verdict == LimitVerdict::unlimited);
      }
  }
}

TEUCHOS_UNIT_TEST(Units, RaisedLoadsMayBeFarSmallerOrLargerThanFixedOnes) {
  for (const double share : {1e-6, 1e-3, 1e3}) {
    auto s = box_on_bed(1, 0.5, {0.6});
    s.stones[1].raised = {share, 0, 0};
    const auto answer = LimitAnalysis(s).largest_factor(1e9);
    TEST_ASSERT(answer.verdict == LimitVerdict::limited);
    TEST_FLOATING_EQUALITY(answer.factor, 0.6 / share, 1e-6);
  }
}

/// Random forces at random places, and each again the other way: on a line through both where a stone is turned.
template <int dim>
Wrench<dim> of_pairs(int pairs, double beside, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Resultant<dim> sum;
  for (int k = 0; k < pairs; ++k) {
    Vector<dim> arm{}, force{};
    for (std::size_t c = 0; c < dim; ++c) arm[c] = any(random), force[c] = 1e6 * any(random);
    sum.add(arm, force);
    sum.add(arm + 1e-7 * any(random) * force, -1.0 * force);
  }
  Vector<dim> small{};
  small[1] = beside;
  sum.add(small, {beside});
  return sum.wrench(1);
}

TEUCHOS_UNIT_TEST(Units, ForcesThatCancelAreNoLoadAndSmallOnesBesideThemAre) {
  for (unsigned seed = 0; seed < 50; ++seed)
    for (const int pairs : {3, 3000}) {
      TEST_ASSERT(of_pairs<2>(pairs, 0, seed) == Wrench<2>{});
      TEST_ASSERT(of_pairs<3>(pairs, 0, seed) == Wrench<3>{});
      TEST_COMPARE(std::abs(of_pairs<2>(pairs, 1, seed)[0] - 1), <, 1e-3);
      TEST_COMPARE(std::abs(of_pairs<3>(pairs, 1, seed)[5] + 1), <, 1e-3);
    }
}

TEUCHOS_UNIT_TEST(Units, StonesThatJamWithoutEndLeaveOthersTheirLimit) {
  // Two held stones side by side, and a stone between held walls that press it as one likes.
  for (const double friction : {0.0, 0.375, 2.0}) {
    auto s = box_on_bed(1, 0.5, {0.3});
    const int neighbour = add_box(s, {-1, -1}, 1, 1, 0);
    hold(s, neighbour);
    add_joint(s, neighbour, 0, {0, 0}, {0, -1}, {friction});
    const int left = add_box(s, {4, 0}, 1, 1, 0), jammed = add_box(s, {5, 0}, 1, 1, 1),
              right = add_box(s, {6, 0}, 1, 1, 0);
    hold(s, left);
    hold(s, right);
    add_joint(s, left, jammed, {5, 1}, {5, 0}, {friction});
    add_joint(s, jammed, right, {6, 1}, {6, 0}, {friction});
    add_joint(s, left, jammed, {5, 0}, {5.5, 0}, {friction});  // a shoulder
    push_sideways(s);
    const auto answer = LimitAnalysis(s).largest_factor(most);
    TEST_ASSERT(answer.verdict == LimitVerdict::limited);
    TEST_FLOATING_EQUALITY(answer.factor, 0.3, 1e-8);
    TEST_ASSERT(answer.out_of_balance < 1e-8);
  }
}

TEUCHOS_UNIT_TEST(LightStones, SlideOnHeavyOnesAtTheirOwnFriction) {
  for (const double share : {1e-2, 1e-4, 1e-6}) {
    auto s = box_on_bed(2, 1, {0.6});
    const int pebble = add_box(s, {0.5, 1}, 0.1, 0.05, share);
    add_joint(s, 1, pebble, {0.5, 1}, {0.6, 1}, {0.3});
    push_sideways(s);
    const auto answer = LimitAnalysis(s).largest_factor(most);
    TEST_ASSERT(answer.verdict == LimitVerdict::limited);
    // Balance is exact to 1e-10 of the heaviest stone.
    TEST_FLOATING_EQUALITY(answer.factor, 0.3, 1e-10 / share + 1e-8);
    TEST_ASSERT(answer.mechanism.at(2)[0] > 0.1);
    for (const double v : answer.mechanism[1]) TEST_ASSERT(std::abs(v) < 1e-8);
  }
}

}  // namespace
