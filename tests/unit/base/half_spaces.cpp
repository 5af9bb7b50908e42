// The shortest vector within half spaces: by hand, and by what marks it among all that lie within.
#include "base/half_spaces.hpp"
#include "base/product.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace voussoir;

constexpr double round_off = 1e-10;  // of vectors of size one: ten times what bounds are kept to

TEUCHOS_UNIT_TEST(HalfSpaces, NothingAskedIsNoVector) {
  TEST_COMPARE_ARRAYS(shortest_within({}, 2), (std::vector<double>{0, 0}));
  TEST_COMPARE_ARRAYS(shortest_within({{{1, 0}, -3}, {{0, 1}, 0}}, 2), (std::vector<double>{0, 0}));
}

TEUCHOS_UNIT_TEST(HalfSpaces, OneBoundIsMetAtRightAnglesTwoInTheirCorner) {
  const auto one = shortest_within({{{0.6, 0.8}, 5}, {{-1, 0}, -9}}, 2);
  TEST_COMPARE_FLOATING_ARRAYS(one, (std::vector<double>{3, 4}), round_off);
  // Right of 2 and above 1e-6: the second counts, small as it is.
  const auto corner = shortest_within({{{1, 0}, 2}, {{0, 1}, 1e-6}}, 2);
  TEST_COMPARE_FLOATING_ARRAYS(corner, (std::vector<double>{2, 1e-6}), round_off);
}

TEUCHOS_UNIT_TEST(HalfSpaces, ThatMissEachOtherHoldNothing) {
  TEST_ASSERT(shortest_within({{{1, 0}, 1}, {{-1, 0}, -0.999}}, 2).empty());
  // Three that leave a triangle outside of each other.
  const double c = std::cos(M_PI / 3), s = std::sin(M_PI / 3);
  TEST_ASSERT(shortest_within({{{-1, 0}, 1}, {{c, s}, 1}, {{c, -s}, 1}}, 2).empty());
  TEST_ASSERT(!shortest_within({{{-1, 0}, -1}, {{c, s}, 0.4}, {{c, -s}, 0.4}}, 2).empty());
}

TEUCHOS_UNIT_TEST(HalfSpaces, NearlyParallelOnesAreToldApart) {
  // Tangents of a disc beside a wall, ever closer to each other: what is nearest is where the disc is.
  for (const double angle : {1e-1, 1e-3, 1e-5, 1e-7}) {
    std::vector<HalfSpace> spaces{{{0, 1}, 0.5}};
    for (int i = -3; i <= 3; ++i) spaces.push_back({{std::cos(i * angle), std::sin(i * angle)}, 1});
    const auto y = shortest_within(spaces, 2);
    TEST_EQUALITY_CONST(y.size(), 2);
    if (y.empty()) continue;
    double least = 1;  // the wall's height, and the farthest that the tangents ask for there
    for (int i = -3; i <= 3; ++i) least = std::max(least, (1 - 0.5 * std::sin(i * angle)) / std::cos(i * angle));
    TEST_FLOATING_EQUALITY(y[0], least, round_off);
    TEST_FLOATING_EQUALITY(y[1], 0.5, round_off);
  }
}

TEUCHOS_UNIT_TEST(HalfSpaces, NoVectorWithinIsShorter) {
  // Around a random vector, at which a third of the borders meet, so that there is one within all. From the nearest one
  // all others lie on the far side of the plane across it.
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  for (int drawn = 0; drawn < 2000; ++drawn) {
    const std::size_t size = 1 + drawn % 8, count = 1 + drawn % 40;
    std::vector<double> inside(size);
    for (auto& value : inside) value = number(random);
    std::vector<HalfSpace> spaces;
    for (std::size_t i = 0; i < count; ++i) {
      HalfSpace h{std::vector<double>(size)};
      for (auto& value : h.slope) value = number(random);
      const double length = std::sqrt(product(h.slope, h.slope));
      for (auto& value : h.slope) value /= length;
      h.least = product(h.slope, inside) - (i % 3 == 0 ? 0.0 : std::abs(number(random)));
      spaces.push_back(h);
    }
    const auto y = shortest_within(spaces, size);
    TEST_EQUALITY(y.size(), size);
    if (y.empty()) continue;
    std::vector<double> beyond(size);
    for (std::size_t i = 0; i < size; ++i) beyond[i] = inside[i] - y[i];
    const double scale = product(inside, inside);
    TEST_COMPARE(product(y, beyond), >=, -1e-9 * scale);
    for (const auto& h : spaces) TEST_COMPARE(product(h.slope, y), >=, h.least - 1e-9 * std::sqrt(scale));
  }
}

}  // namespace
