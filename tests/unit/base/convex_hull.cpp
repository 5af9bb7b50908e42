// Hulls and least rectangles of places, by hand.
#include "base/convex_hull.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace {

using namespace voussoir;

TEUCHOS_UNIT_TEST(ConvexHull, HasTheCornersAndNothingOnASideOrWithin) {
  const std::vector<Vector<2>> l{{1, 1}, {2, 0}, {0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 2}, {0.5, 0.5}};
  const auto hull = convex_hull(l, 1e-9);
  TEST_COMPARE_ARRAYS(hull, (std::vector<int>{2, 1, 4, 5, 6}));
  TEST_EQUALITY(convex_hull({{0, 0}, {2, 0}, {2, 1e-13}, {0, 2}}, 1e-9).size(), 3u);  // one place twice
  TEST_EQUALITY(convex_hull({{3, 3}}, 1e-9).size(), 1u);
  TEST_EQUALITY(convex_hull({{0, 0}, {1, 1}, {2, 2}}, 1e-9).size(), 2u);
}

TEUCHOS_UNIT_TEST(LeastRectangle, LiesAlongASideOfTheHull) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  std::vector<Vector<2>> places;
  for (const auto& x : std::vector<Vector<2>>{{0, 0}, {3, 0}, {3, 1}, {0, 1}, {1, 0.4}})
    places.push_back({5 + c * x[0] - s * x[1], -2 + s * x[0] + c * x[1]});
  const auto r = least_rectangle(places, 1e-9);
  TEST_FLOATING_EQUALITY(r.length[0], 3.0, 1e-12);
  TEST_FLOATING_EQUALITY(r.length[1], 1.0, 1e-12);
  TEST_COMPARE(norm(r.along - Vector<2>{c, s}), <, 1e-12);
  // The right angle of a triangle of 3, 4 and 5 m: 12 m2, and as much along its longest side.
  TEST_FLOATING_EQUALITY(least_rectangle({{0, 0}, {4, 0}, {0, 3}}, 1e-9).area(), 12.0, 1e-12);
}

}  // namespace
