// Joints under stress that is linear along them, with the forces that a finite element mesh gives its points.
#include "joints/coarse_joint.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>
#include <functional>

namespace {

using namespace voussoir;

constexpr double round_off = 1e-13;
constexpr double length = 0.3, thickness = 0.7;

/// Points of a joint of n cells, under pressure that is linear between its edges [Pa] and a uniform shear.
std::vector<BrittlePoint> points(int n, double at_first, double at_last, double shear = 0) {
  const double cell = length / n;
  std::vector<BrittlePoint> all(static_cast<std::size_t>(n) + 1);
  const auto pressure = [&](int k) { return at_first + (at_last - at_first) * k / n; };
  for (int k = 0; k <= n; ++k) all[static_cast<std::size_t>(k)].along = 5 + k * cell;
  // The integral of a linear pressure times a linear shape function over a cell is h (2 p + q) / 6.
  for (int c = 0; c < n; ++c)
    for (const int end : {0, 1}) {
      auto& p = all[static_cast<std::size_t>(c + end)];
      p.area += thickness * cell / 2;
      p.normal_force += thickness * cell * (2 * pressure(c + end) + pressure(c + 1 - end)) / 6;
      p.shear += thickness * cell / 2 * shear;
    }
  return all;
}

TEUCHOS_UNIT_TEST(CoarseJoint, OfBendingIsOverratedByTwoThirdsOfACell) {
  for (const int n : {1, 2, 3, 5, 6, 12}) {
    const auto j = coarse_joint(points(n, -2e6, 2e6), 2e6, 0, 0.6);
    TEST_EQUALITY(j.cells, n);
    TEST_FLOATING_EQUALITY(j.edge_use, 1.0, round_off);
    TEST_FLOATING_EQUALITY(j.point_use, 1 - 2.0 / (3 * n), round_off);
    // With one or two cells points see less than half of the stress: then the strength is compared with that half.
    TEST_FLOATING_EQUALITY(j.overrating, 1 / std::max(0.5, 1 - 2.0 / (3 * n)) - 1, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(CoarseJoint, OfUniformPullOrLittleStressIsNot) {
  for (const int n : {1, 3}) {
    TEST_COMPARE(coarse_joint(points(n, -1.9e6, -1.9e6), 2e6, 1e6, 0.6).overrating, <=, round_off);
    TEST_EQUALITY(coarse_joint(points(n, -0.9e6, 0.9e6), 2e6, 1e6, 0.6).overrating, 0.0);
    TEST_EQUALITY(coarse_joint(points(n, 1e6, 3e6), 2e6, 1e6, 0.6).overrating, 0.0);  // pressed
    TEST_EQUALITY(coarse_joint(points(n, -1e6, 1e6), HUGE_VAL, HUGE_VAL, 0.6).overrating, 0.0);
  }
  // Bending with as much pull: the edge has twice the stress of the middle.
  TEST_FLOATING_EQUALITY(coarse_joint(points(2, -2e6, 0), 2e6, 0, 0).overrating, 2 / (2 - 2.0 / 6) - 1, 1e-12);
}

TEUCHOS_UNIT_TEST(CoarseJoint, OfCohesionAloneCountsAnEdgeThatWouldBeOpen) {
  // Through 0.4 of the length from the middle: three tenths would be pressed.
  auto j = points(1, 0, 0, 0.9e5);
  const double force = 1e4;
  j[0].normal_force = 0.1 * force;
  j[1].normal_force = 0.9 * force;
  const double area = length * thickness, borne = 1e5 * area + 0.5 * force, left = 0.3e5 * area + 0.5 * force;
  TEST_FLOATING_EQUALITY(coarse_joint(j, 0, 1e5, 0.5).overrating, borne / left - 1, 1e-12);
  for (auto& p : j) p.shear /= 10;
  TEST_EQUALITY(coarse_joint(j, 0, 1e5, 0.5).overrating, 0.0);
  TEST_EQUALITY(coarse_joint(points(3, 1e5, 1.5e5, 1e5), 0, 1e5, 0.5).overrating, 0.0);  // pressed all along
}

TEUCHOS_UNIT_TEST(CoarseJoint, ThatHasBrokenWasOverratedAtMostAsInBendingOrShear) {
  auto broken = points(3, 0, 0);
  broken[0].broken = true;
  TEST_FLOATING_EQUALITY(coarse_joint(broken, 2e6, 0, 0).overrating, 1 / (1 - 2.0 / 9) - 1, round_off);
  // The mean of 1 - x^2 times a hat of half the joint's length on either side is 5/6, of the whole joint 2/3.
  auto sheared = points(2, 1e5, 1e5, 1e5);
  sheared[0].broken = true;
  TEST_FLOATING_EQUALITY(coarse_joint(sheared, 0, 1e5, 0.5).overrating, 6.0 / 5 - 1, round_off);
  sheared = points(1, 1e5, 1e5, 1e5);
  sheared[1].broken = true;
  TEST_FLOATING_EQUALITY(coarse_joint(sheared, 0, 1e5, 0.5).overrating, 3.0 / 2 - 1, round_off);
  TEST_EQUALITY(coarse_joint({{}}, 2e6, 0, 0).overrating, 0.0);  // a single point has no length
}

}  // namespace
