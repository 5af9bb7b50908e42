// What a joint carries, against what statics says of it.
#include "joints/joint_statics.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

namespace {

using namespace voussoir;

constexpr double round_off = 1e-14;

/// A joint from (0, 0) to (0, 2) with normal x, its points equally apart: forces and gaps from its lower end up.
std::vector<PointOfJoint<2>> upright(const std::vector<double>& normal_force, const std::vector<double>& shear,
                                     const std::vector<double>& gap, double friction = 0.6) {
  std::vector<PointOfJoint<2>> points;
  const auto n = static_cast<double>(normal_force.size() - 1);
  for (std::size_t k = 0; k < normal_force.size(); ++k)
    points.push_back(
        {{0, 2 * static_cast<double>(k) / n}, {1, 0}, normal_force[k], shear[k], gap[k], {friction, 0, 0}});
  return points;
}

TEUCHOS_UNIT_TEST(JointStatics, UniformPressurePassesThroughTheMiddle) {
  const auto j = joint_statics(upright({1, 2, 1}, {0, 0, 0}, {0, 0, 0}));
  TEST_FLOATING_EQUALITY(j.normal_force, 4.0, round_off);
  TEST_FLOATING_EQUALITY(j.extent, 2.0, round_off);
  TEST_COMPARE(std::abs(j.eccentricity), <, round_off);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.5, round_off);
  TEST_FLOATING_EQUALITY(j.friction_margin, 1.0, round_off);
  TEST_ASSERT(!j.hinge && !j.slides);
  TEST_EQUALITY(j.opening, 0.0);
}

TEUCHOS_UNIT_TEST(JointStatics, EccentricityAndPlaceFollowTheMoment) {
  // 1 N at 0, 3 N at 2 m: through 1.5 m, a quarter of the length from the upper edge.
  const auto j = joint_statics(upright({1, 3}, {0.3, 0.9}, {0, 0}));
  TEST_FLOATING_EQUALITY(j.eccentricity, 0.5, round_off);
  TEST_FLOATING_EQUALITY(j.place[1], 1.5, round_off);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.25, round_off);
  TEST_FLOATING_EQUALITY(j.force[0], 4.0, round_off);
  TEST_FLOATING_EQUALITY(j.force[1], 1.2, round_off);
  TEST_FLOATING_EQUALITY(j.friction_margin, 0.5, 1e-13);  // 1.2 of 0.6 x 4 N
}

TEUCHOS_UNIT_TEST(JointStatics, AHingeIsOpenAtOneEdgeAndPressedAtTheOther) {
  TEST_ASSERT(joint_statics(upright({0, 0, 5}, {0, 0, 0}, {2e-3, 1e-3, 0})).hinge);
  TEST_ASSERT(joint_statics(upright({5, 0, 0}, {0, 0, 0}, {0, 1e-3, 2e-3})).hinge);
  TEST_FLOATING_EQUALITY(joint_statics(upright({5, 0, 0}, {0, 0, 0}, {0, 1e-3, 2e-3})).opening, 2e-3, round_off);
  TEST_ASSERT(!joint_statics(upright({0, 0, 5}, {0, 0, 0}, {1e-13, 1e-13, 0})).hinge);  // closed but for round-off
  TEST_ASSERT(!joint_statics(upright({0, 3, 2}, {0, 0, 0}, {1e-3, 0, 0})).hinge);       // opens, but no more than that
  TEST_ASSERT(!joint_statics(upright({0, 0, 0}, {0, 0, 0}, {2e-3, 1e-3, 0})).hinge);    // nothing turns about nothing
}

TEUCHOS_UNIT_TEST(JointStatics, AJointSlidesWhenAllItsPointsDoTheSameWay) {
  TEST_ASSERT(joint_statics(upright({1, 3}, {-0.6, -1.8}, {0, 0})).slides);
  TEST_ASSERT(!joint_statics(upright({1, 3}, {-0.6, 1.8}, {0, 0})).slides);  // its ends slide, against each other
  TEST_ASSERT(!joint_statics(upright({1, 3}, {-0.6, -1.7}, {0, 0})).slides);
  TEST_ASSERT(!joint_statics(upright({1, 3}, {0.6, 1.8}, {0, 0}, HUGE_VAL)).slides);
}

TEUCHOS_UNIT_TEST(JointStatics, WithoutCompressionThereIsNoPlace) {
  const auto j = joint_statics(upright({0, 0}, {0, 0}, {1e-3, 1e-3}));
  TEST_ASSERT(std::isnan(j.eccentricity) && std::isnan(j.edge_margin) && std::isnan(j.friction_margin));
  TEST_ASSERT(std::isnan(j.place[0]) && !j.hinge && !j.slides);
  TEST_FLOATING_EQUALITY(j.opening, 1e-3, round_off);
}

TEUCHOS_UNIT_TEST(JointStatics, TensionTakesTheResultantOutOfTheJoint) {
  auto points = upright({-1, 3}, {0, 0}, {0, 0});
  for (auto& p : points) p.law = {0.5, 10, 10};
  const auto j = joint_statics(points);
  TEST_FLOATING_EQUALITY(j.eccentricity, 2.0, round_off);  // 4 Nm about the middle by 2 N
  TEST_FLOATING_EQUALITY(j.edge_margin, -0.5, round_off);
}

TEUCHOS_UNIT_TEST(JointStatics, ABentJointHasTheMomentOfItsShearToo) {
  // Two faces at right angles with a stone in their corner: 1 N along x at (0, 1), 1 N along y at (1, 0).
  std::vector<PointOfJoint<2>> points{{{0, 1}, {1, 0}, 1, 0, 0, {0.6, 0, 0}}, {{1, 0}, {0, 1}, 1, 0, 0, {0.6, 0, 0}}};
  const auto j = joint_statics(points);
  TEST_FLOATING_EQUALITY(j.normal_force, std::sqrt(2.0), round_off);
  TEST_COMPARE(std::abs(j.shear), <, round_off);
  TEST_COMPARE(std::abs(j.eccentricity), <, round_off);  // both cross the diagonal through (1, 1)
}

/// Facets between points that follow each other.
std::vector<FacetOfJoint<2>> chain(int points) {
  std::vector<FacetOfJoint<2>> facets;
  for (int k = 0; k + 1 < points; ++k) facets.push_back({k + 1, k});
  return facets;
}

/// A bed along x whose facets fall by so many degrees one after the other; all points press with 1 N.
std::vector<PointOfJoint<2>> bent(const std::vector<double>& degrees, const std::vector<double>& shear) {
  std::vector<PointOfJoint<2>> points(degrees.size() + 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    Vector<2> normal{};
    for (std::size_t f = k > 0 ? k - 1 : 0; f < std::min(k + 1, degrees.size()); ++f) {
      const double a = degrees[f] * 3.14159265358979 / 180;
      normal = normal + Vector<2>{std::sin(a), std::cos(a)};
      if (f == k) points[k + 1].position = points[k].position + Vector<2>{std::cos(a), -std::sin(a)};
    }
    points[k].normal = (1 / norm(normal)) * normal;
    points[k].normal_force = 1;
    points[k].shear = shear[k];
    points[k].law = {0.6, 0, 0};
  }
  return points;
}

TEUCHOS_UNIT_TEST(JointStatics, NoMarginOfABentJointIsBelowZeroWhereItsPointsObeyTheirLaw) {
  // All that an inclined half bears against its slope has a larger share along the mean than friction alone could hold.
  for (const auto& degrees : {std::vector<double>{-5, 5}, {10, 0, -10}, {-15, -5, 0, 5, 15}, {0, 4, 8, 12, 16, 20, 24}})
    for (const double spent : {1.0, -1.0, 0.5}) {
      const auto points = bent(degrees, std::vector<double>(degrees.size() + 1, 0.6 * spent));
      const auto j = joint_statics(points, chain(static_cast<int>(points.size())));
      TEST_EQUALITY(j.sides, 1);
      TEST_COMPARE(std::abs(j.friction_margin - (1 - std::abs(spent))), <, 1e-12);
      TEST_EQUALITY(j.slides, std::abs(spent) == 1);
      TEST_FLOATING_EQUALITY(j.edge_margin, 0.5, 1e-12);  // equal pressures, as if straightened
    }
  auto slope = bent({-5, 5}, {0.6, 0.6, 0});  // a stone pushed over a ridge: its left half is spent, its right one free
  slope[2].normal_force = 0;
  const auto j = joint_statics(slope, chain(3));
  TEST_COMPARE(std::abs(j.friction_margin), <, 1e-12);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.25, 1e-12);
  TEST_FLOATING_EQUALITY(j.edge[0], 0.0, 1e-12);
  TEST_ASSERT(j.slides);
}

TEUCHOS_UNIT_TEST(JointStatics, AJointWithACornerHasTwoSidesAndTellsTheWeakerOne) {
  // A stone in a corner: 4 N on the bed along x, whose friction is spent, 2 N on the wall to its right, which holds.
  std::vector<PointOfJoint<2>> points{{{0, 0}, {0, 1}, 1, -0.6, 0, {0.6, 0, 0}},
                                      {{2, 0}, {0, 1}, 3, -1.8, 0, {0.6, 0, 0}},
                                      {{2, 0}, {-1, 0}, 1, 0.1, 0, {0.6, 0, 0}},
                                      {{2, 1}, {-1, 0}, 1, 0.1, 0, {0.6, 0, 0}}};
  const std::vector<FacetOfJoint<2>> facets{{0, 1}, {2, 3}};
  const auto j = joint_statics(points, facets);
  TEST_EQUALITY(j.sides, 2);
  TEST_COMPARE(std::abs(j.friction_margin), <, 1e-12);
  TEST_FLOATING_EQUALITY(j.least_shear[0], 1.0, 1e-12);  // the bed
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.25, 1e-12);
  TEST_FLOATING_EQUALITY(j.edge[0], 2.0, 1e-12);
  TEST_ASSERT(!j.slides && !j.hinge);  // the wall holds
  points[2].normal_force = points[3].normal_force = points[2].shear = points[3].shear = 0;
  points[2].gap = points[3].gap = 1e-3;
  TEST_ASSERT(joint_statics(points, facets).slides);  // away from the wall
}

TEUCHOS_UNIT_TEST(JointStatics, BondedPointsThatBearBeyondTheirLawLeaveNothing) {
  auto points = upright({1, 3}, {0.7, 2.0}, {0, 0});
  TEST_EQUALITY(joint_statics(points).friction_margin, 0.0);
  points[0].normal_force = -0.1;
  TEST_EQUALITY(joint_statics(points).edge_margin, 0.0);
}

TEUCHOS_UNIT_TEST(JointStatics, WhatRunsRoundHasNoEdge) {
  std::vector<PointOfJoint<2>> points;
  for (int k = 0; k < 36; ++k) {
    const double a = 2 * 3.14159265358979 * k / 36;
    points.push_back({{std::cos(a), std::sin(a)}, {std::cos(a), std::sin(a)}, 1, 0.3, 0, {0.6, 0, 0}});
  }
  auto facets = chain(36);
  facets.push_back({35, 0});
  const auto j = joint_statics(points, facets);
  TEST_EQUALITY(j.sides, 1);
  TEST_ASSERT(std::isnan(j.edge_margin) && !j.hinge);
  TEST_FLOATING_EQUALITY(j.friction_margin, 0.5, 1e-12);
}

TEUCHOS_UNIT_TEST(JointStatics, TurnsWithTheStructure) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  auto points = upright({1, 3, 2}, {0.3, -0.2, 0.1}, {0, 0, 0});
  const auto j = joint_statics(points);
  for (auto& p : points) {
    p.position = {c * p.position[0] - s * p.position[1], s * p.position[0] + c * p.position[1]};
    p.normal = {c, s};
  }
  const auto turned = joint_statics(points);
  TEST_FLOATING_EQUALITY(turned.eccentricity, j.eccentricity, 1e-13);
  TEST_FLOATING_EQUALITY(turned.shear, j.shear, 1e-13);
  TEST_FLOATING_EQUALITY(turned.friction_margin, j.friction_margin, 1e-13);
  TEST_FLOATING_EQUALITY(turned.place[0], -s * j.place[1], 1e-13);
}

}  // namespace
