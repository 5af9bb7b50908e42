// What a joint in space carries, against what statics says of it.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "joints/friction_of_patch.hpp"
#include "joints/joint_statics.hpp"

namespace {

using namespace voussoir;

using Points = std::vector<PointOfJoint<3>>;
constexpr double pi = 3.14159265358979323846, mu = 0.6;

/// A point on the plane z = 0 that presses upwards.
PointOfJoint<3> point(double x, double y, double normal_force, const Vector<2>& shear = {}, double gap = 0) {
  return {{x, y, 0}, {0, 0, 1}, normal_force, {shear[0], shear[1], 0}, gap, {mu, 0, 0}, 1.0};
}

/// Corners and middles of the sides of a rectangle of 4 m along x and 2 m along y, as points of a joint of area 8 m2.
Points rectangle(const std::array<double, 9>& normal_force) {
  Points points;
  for (int k = 0; k < 9; ++k) {
    const int i = k % 3, j = k / 3;
    points.push_back(point(2 * i, j, normal_force[static_cast<std::size_t>(k)]));
    points.back().area = (i == 1 ? 2.0 : 1.0) * (j == 1 ? 2.0 : 1.0) / 2;
  }
  return points;
}

TEUCHOS_UNIT_TEST(JointInSpace, EvenPressurePassesThroughTheMiddle) {
  const auto j = joint_statics(rectangle({1, 2, 1, 2, 4, 2, 1, 2, 1}));
  TEST_FLOATING_EQUALITY(j.extent, 8.0, 1e-14);
  TEST_FLOATING_EQUALITY(j.normal_force, 16.0, 1e-14);
  TEST_COMPARE(norm(j.middle - Vector<3>{2, 1, 0}) + j.eccentricity, <, 1e-14);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.5, 1e-14);
  TEST_FLOATING_EQUALITY(j.friction_margin, 1.0, 1e-14);
  TEST_ASSERT(!j.hinge && !j.slides);
}

TEUCHOS_UNIT_TEST(JointInSpace, EccentricityIsMomentOverForceAndTheMarginOfTheNearestEdge) {
  // 12 N in the middle and 4 N at a corner: through a quarter of the way to that.
  const auto j = joint_statics(rectangle({0, 0, 0, 0, 12, 0, 0, 0, 4}));
  TEST_COMPARE(norm(j.place - Vector<3>{2.5, 1.25, 0}), <, 1e-14);
  TEST_FLOATING_EQUALITY(j.eccentricity, std::hypot(0.5, 0.25), 1e-14);
  TEST_FLOATING_EQUALITY(j.edge_margin, 1.5 / 4, 1e-14);  // as 0.75 / 2 of the other edge
  // 12 N in the middle, 4 N at the middle of a short side: nearer by share to that than to the long sides.
  const auto k = joint_statics(rectangle({0, 0, 0, 0, 12, 4, 0, 0, 0}));
  TEST_FLOATING_EQUALITY(k.edge_margin, 1.5 / 4, 1e-14);
  TEST_COMPARE(norm(k.edge - Vector<3>{4, 1, 0}), <, 1e-14);
}

TEUCHOS_UNIT_TEST(JointInSpace, WhatCountsIsTheConvexHullOfAnLAndOfATrapezoid) {
  // 1 N each at three corners of an L: through (1, 1), next by share to the line across its notch, x + y = 3.
  Points l{point(0, 0, 1), point(2, 0, 0), point(2, 1, 1), point(1, 1, 0), point(1, 2, 1), point(0, 2, 0)};
  auto j = joint_statics(l);
  TEST_FLOATING_EQUALITY(j.edge_margin, 1.0 / 3, 1e-14);
  TEST_COMPARE(norm(j.edge - Vector<3>{1.5, 1.5, 0}), <, 1e-14);
  l[0].normal_force = 0;  // in the notch, outside of the L: at the edge of what can press, and no farther
  j = joint_statics(l);
  TEST_COMPARE(j.edge_margin, <, 1e-14);
  TEST_COMPARE(norm(j.edge - Vector<3>{1.5, 1.5, 0}), <, 1e-14);
  // A trapezoid of 4 and 2 m, 2 m high. 1 N at each of its lower corners, 2 N at the upper left one: through (1.5, 1),
  // 2 / sqrt 5 m from its left leg; across that it is 8 / sqrt 5 m wide, up to (4, 0).
  const Points t{point(0, 0, 1), point(4, 0, 1), point(3, 2, 0), point(1, 2, 2)};
  j = joint_statics(t);
  TEST_COMPARE(norm(j.place - Vector<3>{1.5, 1, 0}), <, 1e-14);
  TEST_FLOATING_EQUALITY(j.edge_margin, 2.0 / 8, 1e-14);
}

/// A square of 1 m with n x n points in the middles of its cells, 1 N on all; each slips as told at its place.
template <class Slip>
Points slipping_square(int n, const Slip& slip) {
  Points points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vector<2> x{(i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5};
      const Vector<2> way = slip(x);
      const double force = 1.0 / (n * n);
      points.push_back(point(x[0], x[1], force, (norm(way) > 0 ? mu * force / norm(way) : 0.0) * way));
      points.back().area = force;
    }
  return points;
}

TEUCHOS_UNIT_TEST(JointInSpace, SlidesWhereAllPointsSlipInOneMotionATwistIncluded) {
  for (const Vector<2>& centre : {Vector<2>{0, 0}, Vector<2>{0.2, 0.1}, Vector<2>{0.05, 0.05}, Vector<2>{3, -2}}) {
    auto points = slipping_square(10, [&](const Vector<2>& x) {
      return Vector<2>{centre[1] - x[1], x[0] - centre[0]};
    });
    auto j = joint_statics(points);
    TEST_COMPARE(std::abs(j.friction_margin), <, 2e-6);
    TEST_ASSERT(j.slides);
    for (auto& p : points) p.shear = 0.5 * p.shear;
    j = joint_statics(points);
    TEST_COMPARE(std::abs(j.friction_margin - 0.5), <, 2e-6);
    TEST_ASSERT(!j.slides);
  }
  // Away from the middle on all sides: each point slips, and all of them together hold.
  const auto j = joint_statics(slipping_square(10, [](const Vector<2>& x) { return x; }));
  TEST_COMPARE(std::abs(j.friction_margin - 1), <, 1e-12);
  TEST_ASSERT(!j.slides);
}

TEUCHOS_UNIT_TEST(FrictionOfAPatch, OfASquareIsTwistedOffByItsMoment) {
  // The mean distance from the middle of a square of side a is 0.3826 a.
  std::vector<RubbingPlace> places;
  for (const auto& p : slipping_square(60, [](const Vector<2>&) { return Vector<2>{}; }))
    places.push_back({{p.position[0], p.position[1]}, {}, p.normal_force});
  places.front().shear = {0, 0.1};
  places.back().shear = {0, -0.1};
  const double moment = 0.1 * (places.back().place[0] - places.front().place[0]);
  TEST_COMPARE(std::abs(friction_used(places) - moment / 0.3826), <, 2e-4 * moment / 0.3826);
}

TEUCHOS_UNIT_TEST(FrictionOfAPatch, OfTwoFeetIsTheirLever) {
  std::vector<RubbingPlace> feet{{{0, 0}, {0, 0.5}, 1}, {{2, 0}, {0, -0.5}, 1}};
  TEST_FLOATING_EQUALITY(friction_used(feet), 0.5, 1e-6);
  feet[1] = {{2, 0}, {0, 0}, 0};  // what bears nothing rubs nothing
  TEST_FLOATING_EQUALITY(friction_used(feet), 0.5, 1e-12);
  feet[1] = {{2, 0}, {0, 9}, HUGE_VAL};
  TEST_EQUALITY(friction_used(feet), 0.0);
  TEST_ASSERT(std::isnan(friction_used({{{0, 0}, {0, 0}, 0}})));
}

TEUCHOS_UNIT_TEST(JointInSpace, AHingeIsOpenAtOneEdgeAndPressedAtTheOther) {
  auto points = rectangle({0, 0, 4, 0, 0, 8, 0, 0, 4});  // along x = 4 m
  TEST_ASSERT(!joint_statics(points).hinge);             // closed all over
  for (int k = 0; k < 9; ++k) points[static_cast<std::size_t>(k)].gap = 1e-3 * (2 - k % 3);
  TEST_ASSERT(joint_statics(points).hinge);
  TEST_FLOATING_EQUALITY(joint_statics(points).opening, 2e-3, 1e-14);
  points[0].normal_force = points[3].normal_force = 8;  // opens on one side, but presses in the middle
  TEST_ASSERT(!joint_statics(points).hinge);
}

TEUCHOS_UNIT_TEST(JointInSpace, TensionTakesTheResultantOutOfTheJointAndNothingPressesNowhere) {
  auto points = rectangle({-1, 0, 0, -2, 0, 8, -1, 0, 0});
  for (auto& p : points) p.law = {mu, 10, 10};
  const auto j = joint_statics(points);
  TEST_FLOATING_EQUALITY(j.edge_margin, -1.0, 1e-13);  // 4 N at 8 m from the side that pulls: 4 m beyond the other
  const auto nothing = joint_statics(rectangle({}));
  TEST_ASSERT(std::isnan(nothing.edge_margin) && std::isnan(nothing.friction_margin));
  TEST_ASSERT(std::isnan(nothing.eccentricity) && std::isnan(nothing.place[0]) && !nothing.hinge && !nothing.slides);
}

TEUCHOS_UNIT_TEST(JointInSpace, TellsTheTwistAboutThePlaceOfTheResultant) {
  auto points = rectangle({0, 0, 0, 0, 12, 4, 0, 0, 0});  // through (2.5, 1)
  points[0].shear = {0, 1, 0};                            // at (0, 0): 2.5 Nm about that, clockwise
  TEST_FLOATING_EQUALITY(joint_statics(points).twist, -2.5, 1e-13);
  TEST_FLOATING_EQUALITY(joint_statics(points).shear, 1.0, 1e-13);
}

TEUCHOS_UNIT_TEST(JointInSpace, NoMarginOfABentSideIsBelowZeroAndACornerPartsTwo) {
  // A ridge along y whose halves fall by five degrees, spent all over along x; its facets share the ridge.
  const double a = 5 * pi / 180;
  Points ridge;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {0.0, 1.0}) {
      const Vector<3> n{std::sin(a * x), 0, std::cos(a * x)};
      ridge.push_back({{x * std::cos(a), y, -std::abs(x) * std::sin(a)},
                       n,
                       1,
                       mu * Vector<3>{n[2], 0, -n[0]},
                       0,
                       {mu, 0, 0},
                       x == 0 ? 1.0 : 0.5});
    }
  const std::vector<FacetOfJoint<3>> facets{{0, 2, 3, 1}, {2, 4, 5, 3}};
  auto j = joint_statics(ridge, facets);
  TEST_EQUALITY(j.sides, 1);
  TEST_COMPARE(std::abs(j.friction_margin), <, 2e-6);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.5, 1e-12);
  TEST_ASSERT(j.slides);
  // A bed whose friction is spent, and a wall to its right that holds: two sides, the weaker is told.
  const auto wall = [](double y, double z) {
    return PointOfJoint<3>{{2, y, z}, {-1, 0, 0}, 1, {0, 0.1, 0}, 0, {mu, 0, 0}, 1};
  };
  const Points corner{point(0, 0, 1, {-mu, 0}),
                      point(2, 0, 3, {-3 * mu, 0}),
                      point(2, 1, 3, {-3 * mu, 0}),
                      point(0, 1, 1, {-mu, 0}),
                      wall(0, 0),
                      wall(1, 0),
                      wall(1, 1),
                      wall(0, 1)};
  j = joint_statics(corner, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  TEST_EQUALITY(j.sides, 2);
  TEST_COMPARE(std::abs(j.friction_margin), <, 2e-6);
  TEST_COMPARE(norm(j.least_shear - Vector<3>{1, 0.5, 0}), <, 1e-12);
  TEST_FLOATING_EQUALITY(j.edge_margin, 0.25, 1e-12);
  TEST_FLOATING_EQUALITY(j.edge[0], 2.0, 1e-12);
  TEST_ASSERT(!j.slides && !j.hinge);
}

TEUCHOS_UNIT_TEST(JointInSpace, TurnsWithTheStructure) {
  auto points = slipping_square(5, [](const Vector<2>& x) { return Vector<2>{1 - x[1], 0.3 + x[0]}; });
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].normal_force *= 1 + 0.1 * static_cast<double>(k);
    points[k].shear = 0.4 * points[k].shear;
  }
  const auto before = joint_statics(points);
  // By 0.7 rad about (1, 2, 2) / 3, then away from the origin.
  const auto turned = [](const Vector<3>& v) {
    const Vector<3> axis{1.0 / 3, 2.0 / 3, 2.0 / 3};
    return std::cos(0.7) * v + std::sin(0.7) * cross(axis, v) + ((1 - std::cos(0.7)) * dot(axis, v)) * axis;
  };
  for (auto& p : points)
    p = {turned(p.position) + Vector<3>{5, -7, 3},
         turned(p.normal),
         p.normal_force,
         turned(p.shear),
         p.gap,
         p.law,
         p.area};
  const auto after = joint_statics(points);
  TEST_FLOATING_EQUALITY(after.edge_margin, before.edge_margin, 1e-12);
  TEST_FLOATING_EQUALITY(after.friction_margin, before.friction_margin, 1e-5);
  TEST_FLOATING_EQUALITY(after.eccentricity, before.eccentricity, 1e-12);
  TEST_FLOATING_EQUALITY(after.twist, before.twist, 1e-9);
  TEST_FLOATING_EQUALITY(after.shear, before.shear, 1e-12);
  TEST_COMPARE(norm(after.force - turned(before.force)), <, 1e-12);
}

}  // namespace
