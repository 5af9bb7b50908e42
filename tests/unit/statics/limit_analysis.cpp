// Largest factors and refusals of rigid structures against closed forms and published ones.
#include <Teuchos_UnitTestHarness.hpp>

#include "unit/statics/structures.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double close = 1e-8, most = 100;

TEUCHOS_UNIT_TEST(LimitAnalysis, ABoxSlidesAtItsFrictionOrTipsAtItsSlenderness) {
  for (const double friction : {0.0, 0.1, 0.6, 2.0, endless})
    for (const double width : {0.2, 1.0, 3.0}) {
      const auto answer = LimitAnalysis(box_on_bed(width, 1, {friction})).largest_factor(most);
      TEST_ASSERT(answer.verdict == LimitVerdict::limited);
      TEST_FLOATING_EQUALITY(1 + answer.factor, 1 + std::min(friction, width), close);
      TEST_EQUALITY(answer.mechanism.size(), 2);
      const auto& bed = answer.mechanism[0];
      const auto& box = answer.mechanism[1];
      for (const double v : bed) TEST_ASSERT(std::abs(v) < close);
      TEST_ASSERT(box[0] > 0.1);
      if (width < friction) TEST_ASSERT(box[2] < -0.1);  // clockwise, over its right edge
    }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, FrictionMayBeAsLargeAsOneLikes) {
  const auto wall_of = [](double friction) { return wall({{2, 2}, {1, 2, 1}, {2, 2}, {1, 2, 1}}, friction); };
  const auto without_end = LimitAnalysis(wall_of(endless)).largest_factor(most);
  TEST_ASSERT(without_end.verdict == LimitVerdict::limited);
  for (const double friction : {8.0, 99.0, 100.0, 1e4, 1e9}) {
    const auto answer = LimitAnalysis(wall_of(friction)).largest_factor(most);
    TEST_ASSERT(answer.verdict == LimitVerdict::limited);
    TEST_FLOATING_EQUALITY(answer.factor, without_end.factor, 1e-6);
  }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, WhatStandsAtTheLargestFactorAskedIsNotLimited) {
  const auto answer = LimitAnalysis(box_on_bed(1, 1, {0.6})).largest_factor(0.5);
  TEST_ASSERT(answer.verdict == LimitVerdict::unlimited);
  TEST_ASSERT(answer.mechanism.empty());
  TEST_ASSERT(answer.out_of_balance < close);
  TEST_FLOATING_EQUALITY(answer.force[0][0] + answer.force[1][0], 1.0, close);
  TEST_FLOATING_EQUALITY(std::abs(answer.force[0][1] + answer.force[1][1]), 0.5, close);
}

TEUCHOS_UNIT_TEST(LimitAnalysis, GivenLoadsAreBorneUpToTheLimitAndRefusedAbove) {
  const LimitAnalysis box(box_on_bed(1, 1, {0.6}));
  TEST_ASSERT(box.bears(0.6 - 1e-4).verdict == LimitVerdict::unlimited);
  const auto refused = box.bears(0.6 + 1e-4);
  TEST_ASSERT(refused.verdict == LimitVerdict::refused);
  TEST_ASSERT(refused.mechanism.at(1)[0] > 0.1);
}

TEUCHOS_UNIT_TEST(LimitAnalysis, AHangingStoneIsRefusedAndFalls) {
  for (const double weight : {1.0, 1e-6}) {  // of what stands beside it
    auto s = box_on_bed(1, 1, {0.6});
    const int ceiling = add_box(s, {5, 3}, 1, 1, 0), hanging = add_box(s, {5, 2}, 1, 1, weight);
    hold(s, ceiling);
    add_joint(s, ceiling, hanging, {6, 3}, {5, 3}, {0.6});
    const LimitAnalysis analysis(s);
    for (const auto& answer : {analysis.bears(0), analysis.largest_factor(most)}) {
      TEST_ASSERT(answer.verdict == LimitVerdict::refused);
      TEST_ASSERT(answer.mechanism.at(static_cast<std::size_t>(hanging))[1] < -0.1);
      for (const int other : {0, 1, ceiling})
        for (const double v : answer.mechanism[static_cast<std::size_t>(other)]) TEST_ASSERT(std::abs(v) < close);
    }
    for (const double share : {0.51, 0.49}) {  // of the weight, borne by each of two points
      for (auto& c : s.contacts) c.law = {0.6, weight, share * weight};
      const auto answer = LimitAnalysis(s).bears(0);
      TEST_ASSERT(answer.verdict == (share > 0.5 ? LimitVerdict::unlimited : LimitVerdict::refused));
    }
  }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, CohesionAndTensionOfAJointAddToWhatItBears) {
  const double friction = 0.3, cohesion = 0.25, tension = 0.05;  // of each of two points
  const double slides = friction + 2 * cohesion;
  const auto wide = LimitAnalysis(box_on_bed(9, 1, {friction, cohesion, tension})).largest_factor(most);
  TEST_FLOATING_EQUALITY(wide.factor, slides, close);
  // About the right edge: push x h/2 = (weight/2 + tension) x width.
  const auto slender = LimitAnalysis(box_on_bed(0.4, 1, {friction, cohesion, tension})).largest_factor(most);
  TEST_FLOATING_EQUALITY(slender.factor, 2 * (0.5 + tension) * 0.4, close);
  // Tension beyond the vertex of the cone is worth as much as at the vertex.
  const auto cut = LimitAnalysis(box_on_bed(0.3, 1, {0.4, 0.2, 7})).largest_factor(most);
  TEST_FLOATING_EQUALITY(cut.factor, 2 * (0.5 + 0.2 / 0.4) * 0.3, close);
  const auto glued = LimitAnalysis(box_on_bed(0.4, 1, {0.4, endless, endless})).largest_factor(most);
  TEST_ASSERT(glued.verdict == LimitVerdict::unlimited);
}

TEUCHOS_UNIT_TEST(LimitAnalysis, OppenheimsArch) {
  const auto answer = LimitAnalysis(ring(7, 10, 1.5, 157.5 / 180 * pi, {1.0})).largest_factor(most);
  TEST_ASSERT(answer.verdict == LimitVerdict::limited);
  TEST_FLOATING_EQUALITY(answer.factor, 0.3700, 1e-4 / 0.37);
}

TEUCHOS_UNIT_TEST(LimitAnalysis, TheThinnestSemicirclesOfTheTable) {
  const std::vector<std::pair<double, double>> table{{1.0, 0.10678}, {0.375, 0.12539}, {0.35, 0.15059}};
  for (const auto& [friction, thickness] : table)
    for (const double aside : {-1e-4, 1e-4}) {
      const auto answer = LimitAnalysis(ring(27, 1, thickness + aside, pi, {friction})).bears(0);
      TEST_ASSERT(answer.verdict == (aside < 0 ? LimitVerdict::refused : LimitVerdict::unlimited));
    }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, BelowALeastFrictionNoSemicircleStandsHoweverThick) {
  // Half a ring of weight 1 with a thrust H: the springings ask for tan(friction angle) >= 2 H, a joint at an angle t
  // from the crown for atan(t / (pi H)) - t at most. 0.3092 for many voussoirs, 0.30899 for 27.
  const int voussoirs = 27;
  double few = 0.2, enough = 0.4;
  while (enough - few > 1e-7) {
    const double friction = (few + enough) / 2;
    double asks = 0;
    for (int k = 0; 2 * k + 1 < voussoirs; ++k) {
      const double t = (k + 0.5) * pi / voussoirs;
      asks = std::max(asks, std::atan(2 * t / (pi * friction)) - t);
    }
    (asks > std::atan(friction) ? few : enough) = friction;
  }
  TEST_FLOATING_EQUALITY(enough, 0.3090, 1e-4);
  for (double thickness = 0.05; thickness < 1; thickness *= 1.05)
    TEST_ASSERT(LimitAnalysis(ring(voussoirs, 1, thickness, pi, {few - 1e-5})).bears(0).verdict ==
                LimitVerdict::refused);
  TEST_ASSERT(LimitAnalysis(ring(voussoirs, 1, 0.4, pi, {enough + 1e-5})).bears(0).verdict == LimitVerdict::unlimited);
}

TEUCHOS_UNIT_TEST(LimitAnalysis, TheWallsOfFerrisAndTinLoi) {
  const std::vector<int> half{1, 2, 2, 2, 2, 1}, whole{2, 2, 2, 2, 2};
  const std::vector<int> a{2, 2, 2, 2}, b{1, 2, 2, 2, 1}, w{1, 2, -2, 2, 1}, v{2, 1, -2, 1, 2};
  const std::vector<int> e{1, 2, 2, 1}, u{2, 2, 2}, x{2, -2, 2}, y{1, 1, -2, 1, 1};
  const std::vector<std::pair<std::vector<std::vector<int>>, double>> walls{
      {{half, whole, half, whole, half, whole}, 0.643},
      {{half, whole, half, whole, half, whole, half, whole, half, whole}, 0.580},
      {{a, b, a, w, v, w, v, w, a, b, a}, 0.404},
      {{e, u, e, x, y, x, y, x, e, u, e, x, y, x, y, x, e, u, e}, 0.240}};
  for (const auto& [courses, published] : walls) {
    const LimitAnalysis analysis(wall(courses, 0.65));
    const auto answer = analysis.largest_factor(most);
    TEST_ASSERT(answer.verdict == LimitVerdict::limited);
    TEST_FLOATING_EQUALITY(answer.factor, published, 1e-3 / published);
    const auto estimate = analysis.without_dilatancy(most, analysis.largest_factor(most));
    TEST_ASSERT(estimate && *estimate <= answer.factor + close && *estimate > 0.8 * answer.factor);
  }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, SlipThatNeitherLiftsNorIsLiftedIsEstimatedAsItIs) {
  for (const double width : {0.5, 2.0}) {
    const LimitAnalysis box(box_on_bed(width, 1, {0.6}));
    const auto estimate = box.without_dilatancy(most, box.largest_factor(most));
    TEST_ASSERT(estimate.has_value());
    TEST_FLOATING_EQUALITY(estimate.value_or(0), std::min(0.6, width), 1e-3);
  }
}

TEUCHOS_UNIT_TEST(LimitAnalysis, AWallThatSlidesBearsLessWithoutDilatancy) {
  // The sixth wall: published are 0.347 with dilatancy and 0.297 as the least without.
  const std::vector<int> e{1, 2, 2, 2, 2, 2, 2, 1}, u{2, 2, 2, 2, 2, 2, 2}, w{1, 2, -2, 2, 2, -2, 2, 1},
      v{2, 1, -2, 1, 2, 1, -2, 1, 2};
  const LimitAnalysis analysis(wall({e, u, e, u, w, v, w, v, w, u, e, u, w, v, w, v, w, u, e, u, e}, 0.65));
  const auto answer = analysis.largest_factor(most);
  TEST_FLOATING_EQUALITY(answer.factor, 0.3478, 1e-3);
  const auto estimate = analysis.without_dilatancy(most, analysis.largest_factor(most));
  TEST_ASSERT(estimate && *estimate < 0.9 * answer.factor);
  TEST_ASSERT(estimate && *estimate > 0.297 * 0.98);  // published
}

}  // namespace
