// Forces shared out among joints, against what equilibrium says where it says all.
#include <Teuchos_UnitTestHarness.hpp>

#include "range/joint_network.hpp"

namespace {

using namespace voussoir;

// Stones without joints are held by 1e-9 of the stiffness; what that takes off the others is as small.
constexpr double held = 1e-6;

const std::array<Vector<2>, 2> up{{{0, 1}, {-1, 0}}};  // the normal of a bed, and its tangent

/// Two stones of height 2 on each other, the lower on the ground.
std::vector<NetworkJoint<2>> stack() {
  return {{-1, 0, {}, {0, -1}, up, {3, 5, 7}}, {0, 1, {0, 1}, {0, -1}, up, {2, 1, 4}}};
}

TEUCHOS_UNIT_TEST(JointNetwork, AStackBearsWhatStandsOnEachBedWhateverItsStiffness) {
  const auto borne = borne_by_network<2>(2, stack(), {{0, -10, 0}, {4, -20, 1}});
  // On the upper bed: the weight of the upper stone, its push of 4 N a metre above, and its moment.
  TEST_FLOATING_EQUALITY(borne[1][0], 20.0, held);
  TEST_FLOATING_EQUALITY(borne[1][1], 4.0, held);  // the normal turned by +90 degrees points to -x
  TEST_FLOATING_EQUALITY(borne[1][2], -1.0 + 4 * 1, held);
  TEST_FLOATING_EQUALITY(borne[0][0], 30.0, held);
  TEST_FLOATING_EQUALITY(borne[0][1], 4.0, held);
  TEST_FLOATING_EQUALITY(borne[0][2], -1.0 + 4 * 3, held);
}

TEUCHOS_UNIT_TEST(JointNetwork, WhereEquilibriumLeavesAChoiceStiffJointsBearMore) {
  // One stone on two beds, 1 m to either side of its middle, one three times as stiff: it turns a little.
  const auto beds = [](double right) {
    return std::vector<NetworkJoint<2>>{{-1, 0, {}, {-1, -1}, up, {1, 1, 1}},
                                        {-1, 0, {}, {1, -1}, up, {right, right, right}}};
  };
  const auto alike = borne_by_network<2>(1, beds(1), {{0, -8, 0}}),
             unlike = borne_by_network<2>(1, beds(3), {{0, -8, 0}});
  TEST_FLOATING_EQUALITY(alike[0][0], 4.0, held);
  TEST_ASSERT(unlike[1][0] > 4.1);
  TEST_FLOATING_EQUALITY(unlike[0][0] + unlike[1][0], 8.0, held);
  // Moments about the middle of the stone: (left - right) x 1 m, shear 1 m below, and what the beds bear as moments.
  TEST_COMPARE(std::abs(unlike[1][0] - unlike[0][0] - (unlike[0][1] + unlike[1][1]) + unlike[0][2] + unlike[1][2]), <,
               8 * held);
}

TEUCHOS_UNIT_TEST(JointNetwork, WhatNothingHoldsIsLeftUnborne) {
  const auto borne =
      borne_by_network<2>(2, {{0, 1, {1, 0}, {-1, 0}, {{{1, 0}, {0, 1}}}, {1, 1, 1}}}, {{-3, 0, 0}, {3, 0, 0}});
  TEST_FLOATING_EQUALITY(borne[0][0], -3.0, held);  // drawn apart: the joint is in tension
  TEST_EQUALITY(borne_by_network<2>(1, {}, {{1, 1, 1}}).size(), 0u);
}

// In space: a stone on a bed beside its middle; its weight, a push along y, and a twist.
TEUCHOS_UNIT_TEST(JointNetwork, BearsForcesAndMomentsOfSpace) {
  const std::array<Vector<3>, 3> axes{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  const auto borne =
      borne_by_network<3>(1, {{-1, 0, {}, {0.5, 0, -1}, axes, {1, 2, 3, 4, 5, 6}}}, {{0, 3, -10, 0, 0, 2}});
  const std::array<double, 6> expected{10, 0, -3, -2 + 0.5 * 3, 3, 0.5 * 10};
  for (int k = 0; k < 6; ++k) TEST_COMPARE(std::abs(borne[0][k] - expected[k]), <, 10 * held);
}

}  // namespace
