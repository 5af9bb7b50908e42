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
  for (int k = 0; k <= n; ++k) all[static_cast<std::size_t>(k)].place[0] = 5 + k * cell;
  // The integral of a linear pressure times a linear shape function over a cell is h (2 p + q) / 6.
  for (int c = 0; c < n; ++c)
    for (const int end : {0, 1}) {
      auto& p = all[static_cast<std::size_t>(c + end)];
      p.area += thickness * cell / 2;
      p.normal_force += thickness * cell * (2 * pressure(c + end) + pressure(c + 1 - end)) / 6;
      p.shear[0] += thickness * cell / 2 * shear;
    }
  return all;
}

/// The joint that they are of.
JointSection strip(int n) {
  JointSection section;
  section.area = length * thickness;
  section.middle = {5 + length / 2, 0};
  section.second_moment[0][0] = section.area * length * length / 12;
  section.length = {length, 0};
  section.cells = {n, 0};
  return section;
}

CoarseJoint coarse_joint(const std::vector<BrittlePoint>& points, double tension, double cohesion, double friction) {
  return voussoir::coarse_joint(strip(static_cast<int>(points.size()) - 1), points, tension, cohesion, friction);
}

TEUCHOS_UNIT_TEST(CoarseJoint, OfBendingIsOverratedByTwoThirdsOfACell) {
  for (const int n : {1, 2, 3, 5, 6, 12}) {
    const auto j = coarse_joint(points(n, -2e6, 2e6), 2e6, 0, 0.6);
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
  for (auto& p : j) p.shear[0] /= 10;
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

/// A rectangle of n x m cells under a pressure that is linear over it.
struct Rectangular {
  JointSection section;
  std::vector<BrittlePoint> points;

  Rectangular(int n, int m, double middle, double along, double across) {
    const double wide = 0.2;
    section.area = length * wide;
    section.second_moment = {{{section.area * length * length / 12, 0}, {0, section.area * wide * wide / 12}}};
    section.length = {length, wide};
    section.cells = {n, m};
    points.resize(static_cast<std::size_t>((n + 1) * (m + 1)));
    const double a = length / n, b = wide / m;
    const auto at = [&](int i, int j) -> BrittlePoint& { return points[static_cast<std::size_t>(i * (m + 1) + j)]; };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) at(i, j).place = {i * a - length / 2, j * b - wide / 2};
    // A linear stress on a cell: its mean weighted by the shape function of a corner is that a third of the way in.
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j)
        for (const int e : {0, 1})
          for (const int f : {0, 1}) {
            auto& p = at(i + e, j + f);
            const double x = p.place[0] + (e == 0 ? 1 : -1) * a / 3, y = p.place[1] + (f == 0 ? 1 : -1) * b / 3;
            p.area += a * b / 4;
            p.normal_force += a * b / 4 * (middle + along * 2 * x / length + across * 2 * y / wide);
          }
  }
  double overrating(double tension, double cohesion = 0) const {
    return voussoir::coarse_joint(section, points, tension, cohesion, 0.6).overrating;
  }
};

TEUCHOS_UNIT_TEST(CoarseJoint, InSpaceBendsAboutBothAxes) {
  TEST_FLOATING_EQUALITY(Rectangular(3, 1, 0, 1.8e6, 0).overrating(2e6), 1 / (1 - 2.0 / 9) - 1, 1e-9);
  TEST_FLOATING_EQUALITY(Rectangular(3, 2, 0, 1e6, 1e6).overrating(2e6), 2 / (7.0 / 9 + 2.0 / 3) - 1, 1e-9);
  TEST_COMPARE(Rectangular(3, 1, -1.9e6, 0, 0).overrating(2e6), <, 1e-9);
  // Seven cells along the bending, one across: as fine as a joint of the plane of as many.
  TEST_COMPARE(Rectangular(7, 1, 0, 1.9e6, 0).overrating(2e6), <, 0.01);
  TEST_FLOATING_EQUALITY(Rectangular(7, 3, 0, 0, 1.9e6).overrating(2e6), 1 / (1 - 2.0 / 9) - 1, 1e-9);
  TEST_ASSERT(Rectangular(7, 6, 0, 0, 0).section.is_fine() && !Rectangular(7, 5, 0, 0, 0).section.is_fine());
}

TEUCHOS_UNIT_TEST(CoarseJoint, InSpaceBreaksTheWayItHasOpened) {
  Rectangular joint(4, 1, 0, 0, 0);
  const auto open = [&](double even, double along) {
    for (auto& p : joint.points) {
      p.opened = even + along * p.place[0];
      p.broken = p.opened > 0;
    }
    return joint.overrating(2e6);
  };
  TEST_FLOATING_EQUALITY(open(1e-4, 1e-3), 1 / (1 - 2.0 / 12) - 1, 1e-12);  // along its four cells
  TEST_EQUALITY(open(1e-4, 0), 0.0);                                        // pulled apart
  for (auto& p : joint.points) p.shear = {0, 1e3};
  open(0, 0);
  joint.points[0].broken = true;
  TEST_FLOATING_EQUALITY(joint.overrating(0, 1e5), 0.5, 1e-12);  // sheared across, where it has one cell
}

}  // namespace
