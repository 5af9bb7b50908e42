// The slacks of friction of one point: with one tangent two pairs of numbers, with two a matrix each.
#include "nonlinear/friction_disc.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace voussoir;
using Pair = std::array<double, 2>;

constexpr double bound = 30, stiffness = 1e6, distance = 1e-5;  // [N], [N/m], [m]
constexpr FrictionDisc::Start start{bound, 1, distance};

Pair turned(const Pair& v, double angle) {
  return {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]};
}

/// Newton's method with a barrier [J] for a point that has slipped, whose bound stays.
Pair friction_of(const Pair& slip, double barrier, int tangents, Pair q = {}) {
  FrictionDisc disc;
  disc.enter(tangents, q.data(), slip.data(), start);
  for (int step = 0; step < 60; ++step) {
    disc.scale(0);
    const auto change = disc.friction(disc.right_hand_side(q.data(), slip.data(), bound, barrier));
    disc.direct(change.data(), 0);
    const double length = std::min(1.0, 0.99 * disc.way_out());
    for (int t = 0; t < tangents; ++t) q[t] += length * change[t];
    disc.advance(length);
  }
  return q;
}

TEUCHOS_UNIT_TEST(FrictionDisc, OfOneTangentResistsAsTwoPairsOfSlacksDo) {
  const double q = 12, slip = -3e-5, floor = 1e-7;
  FrictionDisc disc;
  disc.enter(1, &q, &slip, start);
  disc.scale(floor);
  const double against = (distance - slip) / (bound - q), along = distance / (bound + q);
  TEST_EQUALITY(disc.resistance()[0], 1 / (against + along + floor));
  TEST_EQUALITY(disc.drag(0.5).along, 0.5 * (along - against));
  TEST_EQUALITY(disc.drag(0.5).across, 0.0);
}

// Friction against the slip with one number between them, Y = 2 nu / (b^2 - |q|^2), wherever the path came from.
TEUCHOS_UNIT_TEST(FrictionDisc, LeadsToFrictionAgainstTheSlip) {
  for (const int tangents : {1, 2})
    for (const double barrier : {1e-3, 1e-6, 1e-9})
      for (int k = 0; k < 8; ++k) {
        const double angle = tangents == 1 ? std::acos(-1.0) * k : 0.3 + 0.8 * k;
        const Pair slip = turned({2e-5, 0}, angle), from = turned({0.9 * bound, 0}, 1.7 * angle);
        const auto q =
            friction_of({slip[0], tangents == 1 ? 0 : slip[1]}, barrier, tangents, tangents == 1 ? Pair{} : from);
        const double y = 2 * barrier / (bound * bound - q[0] * q[0] - q[1] * q[1]);
        for (int t = 0; t < tangents; ++t) TEST_COMPARE(std::abs(slip[t] + y * q[t]), <=, 1e-9 * 2e-5);
      }
}

TEUCHOS_UNIT_TEST(FrictionDisc, TurnsWithItsAxes) {
  const Pair q{10, 5}, slip{4e-5, -7e-5};
  FrictionDisc one, other;
  const double angle = 0.7;
  const auto q_turned = turned(q, angle), slip_turned = turned(slip, angle);
  one.enter(2, q.data(), slip.data(), start);
  other.enter(2, q_turned.data(), slip_turned.data(), start);
  for (int step = 0; step < 3; ++step) {
    one.scale(1e-7);
    other.scale(1e-7);
    const auto a = one.resistance(), b = other.resistance();
    TEST_COMPARE(a[0] * a[2], >, a[1] * a[1]);
    TEST_FLOATING_EQUALITY(a[0] + a[2], b[0] + b[2], 1e-12);
    TEST_FLOATING_EQUALITY(a[0] * a[2] - a[1] * a[1], b[0] * b[2] - b[1] * b[1], 1e-11);
    const auto change = one.friction(one.right_hand_side(q.data(), slip.data(), bound, 1e-5));
    const auto other_change = other.friction(other.right_hand_side(q_turned.data(), slip_turned.data(), bound, 1e-5));
    const auto expected = turned(change, angle);
    for (int t = 0; t < 2; ++t) TEST_COMPARE(std::abs(other_change[t] - expected[t]), <=, 1e-11 * bound);
    one.direct(change.data(), 2);
    other.direct(other_change.data(), 2);
    TEST_FLOATING_EQUALITY(one.way_out(), other.way_out(), 1e-9);
    one.advance(0.3 * std::min(1.0, one.way_out()));
    other.advance(0.3 * std::min(1.0, other.way_out()));
  }
}

// On the path, W Y = nu 1, motions go the other way than forces. So a step ends where the force leaves the disc, ahead
// or behind.
TEUCHOS_UNIT_TEST(FrictionDisc, EndsAStepWhereTheForceLeavesTheDisc) {
  const Pair q{0, bound / 2}, slip{0, -4.0 / 3};  // of nu = bound x 1 m
  for (const double angle : {0.0, 0.4, 1.5, 2.6, 4.0}) {
    const auto change = turned({0, bound}, angle);
    FrictionDisc disc;
    disc.enter(2, q.data(), slip.data(), {bound, 1, 2.0 / 3});
    disc.scale(0);
    const auto wanted = disc.right_hand_side(q.data(), slip.data(), bound, bound);
    TEST_COMPARE(std::hypot(wanted.along, wanted.across), <=, 1e-14);
    disc.direct(change.data(), 0);
    double nearest = 2;
    for (const int sign : {1, -1}) {
      const double towards = sign * q[1] * std::cos(angle);
      nearest = std::min(nearest, (std::hypot(towards, std::sqrt(0.75) * bound) - towards) / bound);
    }
    TEST_FLOATING_EQUALITY(disc.way_out(), nearest, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(FrictionDisc, IsASpringWhereTheLawBoundsNothing) {
  for (const int tangents : {1, 2}) {
    const Pair q{1e3, -2e3}, slip{1e-5, 2e-5};
    FrictionDisc disc;
    disc.enter(tangents, q.data(), slip.data(), {std::numeric_limits<double>::infinity(), 1, distance});
    disc.scale(1 / stiffness);
    const auto change = disc.friction(disc.right_hand_side(q.data(), slip.data(), bound, 1));
    for (int t = 0; t < tangents; ++t) TEST_FLOATING_EQUALITY(change[t], -stiffness * slip[t], 1e-14);
    disc.direct(change.data(), 0);
    TEST_ASSERT(std::isinf(disc.way_out()));
    TEST_ASSERT(!disc.slips(stiffness));
  }
}

TEUCHOS_UNIT_TEST(FrictionDisc, CutsFrictionToItsBound) {
  Pair q{30, 40};
  hold_within(25, q.data(), 2);
  TEST_FLOATING_EQUALITY(q[0], 15.0, 1e-15);
  TEST_FLOATING_EQUALITY(q[1], 20.0, 1e-15);
  double alone = -0.7;
  hold_within(0.3, &alone, 1);
  TEST_EQUALITY(alone, -0.3);
}

}  // namespace
