// Rotations of the plane and of space, however far.
#include "base/rotation.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace voussoir;

constexpr double round_off = 1e-14;
const double pi = std::acos(-1.0);

template <int dim>
void check_equal(const Vector<dim>& a, const Vector<dim>& b, double within, Teuchos::FancyOStream& out, bool& success) {
  for (int c = 0; c < dim; ++c) TEST_COMPARE(std::abs(a[c] - b[c]), <=, within);
}

/// The rotation nearest to what one does to some arms about their middle.
template <int dim>
Rotation<dim> found(const std::vector<Vector<dim>>& arms, const Rotation<dim>& rotation) {
  NearestRotation<dim> nearest;
  for (const auto& r : arms) nearest.add(r, rotation(r) - r);
  return nearest.found();
}

const std::vector<Vector<3>> corners{{1, 0, 0},       {-1, 0, 0},    {0, 0.3, 0.1},
                                     {0, -0.3, -0.1}, {0.2, 0, 0.4}, {-0.2, 0, -0.4}};

TEUCHOS_UNIT_TEST(Rotation, TurnsRightHandedAboutItsDirection) {
  const Rotation<3> quarter({0, 0, 1}, pi / 2);
  check_equal<3>(quarter({1, 0, 0}), {0, 1, 0}, round_off, out, success);
  check_equal<3>(quarter({0, 1, 2}), {-1, 0, 2}, round_off, out, success);
  check_equal<3>(quarter.back()(quarter({1, 2, 3})), {1, 2, 3}, round_off, out, success);
  check_equal<3>(quarter.vector(), {0, 0, pi / 2}, round_off, out, success);
  check_equal<3>(rotation_about<3>({0, 0, 1}, 0.3)({1, 2, 0}),
                 {std::cos(0.3) - 2 * std::sin(0.3), std::sin(0.3) + 2 * std::cos(0.3), 0}, round_off, out, success);
  check_equal<2>(rotation_about<2>({0, 0, 1}, 0.3)({1, 2}),
                 {std::cos(0.3) - 2 * std::sin(0.3), std::sin(0.3) + 2 * std::cos(0.3)}, round_off, out, success);
}

// Axes of a joint turn by half of what its blocks have turned against each other.
TEUCHOS_UNIT_TEST(Rotation, HalfTheWayIsAsFarFromEitherEnd) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 50; ++k) {
    const auto a = Rotation<3>::of_quaternion(any(random), {any(random), any(random), any(random)});
    const auto b = Rotation<3>::of_quaternion(any(random), {any(random), any(random), any(random)});
    const auto middle = a.halfway_to(b);
    TEST_COMPARE(std::abs(middle.apart(a) - a.apart(b) / 2), <=, round_off);
    TEST_COMPARE(std::abs(middle.apart(b) - a.apart(b) / 2), <=, round_off);
    TEST_COMPARE(a.apart(b), <=, pi);
  }
  // Stones that have turned past half a turn have angles near pi and near -pi.
  for (int k = 0; k < 50; ++k) {
    const Rotation<2> a(9 * any(random)), b(9 * any(random)), middle = a.halfway_to(b);
    TEST_COMPARE(std::abs(middle.apart(a) - a.apart(b) / 2), <=, round_off);
    TEST_COMPARE(std::abs(middle.apart(b) - a.apart(b) / 2), <=, round_off);
    TEST_COMPARE(a.apart(b), <=, pi);
    TEST_COMPARE(
        std::abs(a.apart(b) -
                 rotation_about<3>({0, 0, 1}, a.vector()[2]).apart(rotation_about<3>({0, 0, 1}, b.vector()[2]))),
        <=, round_off);
  }
}

TEUCHOS_UNIT_TEST(Rotation, TheNearestToABodysMotionIsThatOfTheBody) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 50; ++k) {
    const auto r = Rotation<3>::of_quaternion(any(random), {any(random), any(random), any(random)});
    TEST_COMPARE(found(corners, r).apart(r), <=, round_off);
    const Rotation<2> flat(3 * any(random));
    TEST_COMPARE(found<2>({{1, 0}, {-1, 0}, {0, 0.1}, {0, -0.1}}, flat).apart(flat), <=, round_off);
  }
  // Half a turn, which has no whole part, and ones that are all but none.
  for (const double angle : {pi, 1e-3, 1e-7, 1e-11}) {
    const Rotation<3> r({0.6, 0, 0.8}, angle);
    TEST_COMPARE(found(corners, r).apart(r), <=, round_off);
    check_equal<3>(found(corners, r)({1, 2, 3}), r({1, 2, 3}), 10 * round_off, out, success);
  }
}

// Blocks that have not turned share a matrix, so they must be known to the last bit.
TEUCHOS_UNIT_TEST(Rotation, WhatOnlyMovesOrStretchesHasNotTurned) {
  TEST_ASSERT(found(corners, Rotation<3>()) == Rotation<3>());
  NearestRotation<3> stretched;
  for (const auto& r : corners) stretched.add(r, (1.0 / 1024) * r);  // exactly
  TEST_ASSERT(stretched.found() == Rotation<3>());
}

}  // namespace
