// Polygons in a plane: common parts, corners, triangles.
#include "stones/polygon.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

namespace {

using namespace voussoir;

Polygon square(double x, double y, double side) { return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}; }

TEUCHOS_UNIT_TEST(Polygon, AreaPerimeterAndWidthOfARectangle) {
  const Polygon strip{{1, 1}, {11, 1}, {11, 1.1}, {1, 1.1}};
  TEST_FLOATING_EQUALITY(area(strip), 1.0, 1e-14);
  TEST_FLOATING_EQUALITY(perimeter(strip), 20.2, 1e-14);
  TEST_FLOATING_EQUALITY(mean_width(strip), 2 / 20.2, 1e-14);
}

TEUCHOS_UNIT_TEST(Polygon, CommonPartsAreThoseOfTheDrawing) {
  TEST_FLOATING_EQUALITY(area(common_part(square(0, 0, 1), square(0.25, 0.5, 1))), 0.375, 1e-15);
  TEST_FLOATING_EQUALITY(area(common_part(square(0, 0, 1), square(0, 0, 1))), 1.0, 1e-15);
  TEST_FLOATING_EQUALITY(area(common_part(square(-5, -5, 10), square(0, 0, 1))), 1.0, 1e-15);
  TEST_ASSERT(common_part(square(0, 0, 1), square(2, 0, 1)).size() < 3);
  // Squares that only touch have no area in common.
  TEST_COMPARE(std::abs(area(common_part(square(0, 0, 1), square(1, 0, 1)))), <=, 1e-15);
  // A square and the same turned by 45 degrees: an octagon of 2 (sqrt 2 - 1).
  const double r = std::sqrt(0.5);
  const Polygon diamond{{0.5, 0.5 - r}, {0.5 + r, 0.5}, {0.5, 0.5 + r}, {0.5 - r, 0.5}};
  TEST_EQUALITY(common_part(square(0, 0, 1), diamond).size(), 8u);
  TEST_FLOATING_EQUALITY(area(common_part(square(0, 0, 1), diamond)), 2 * (std::sqrt(2.0) - 1), 1e-14);
}

TEUCHOS_UNIT_TEST(Polygon, CornersOnAStraightLineAreNone) {
  const Polygon p{{0, 0}, {0.5, 1e-4}, {1, 0}, {1, 1}, {1, 1.0001}, {0, 1}, {0, 0.5}};
  TEST_EQUALITY(corners_of(p, 1e-3).size(), 4u);
  TEST_EQUALITY(corners_of(p, 1e-6).size(), 5u);
}

TEUCHOS_UNIT_TEST(Polygon, PointsInsideAreHeld) {
  const Polygon bent{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TEST_ASSERT(holds(bent, {0.5, 1.5}) && holds(bent, {1.5, 0.5}) && !holds(bent, {1.5, 1.5}));
  TEST_ASSERT(!is_convex(bent, 1e-6) && is_convex(square(0, 0, 1), 0));
}

TEUCHOS_UNIT_TEST(Polygon, TrianglesCoverAPolygonThatIsNotConvex) {
  const std::vector<Vector<3>> bent{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  double sum = 0;
  for (const auto& t : cut_into_triangles(bent)) {
    const double part = cross(bent[t[1]] - bent[t[0]], bent[t[2]] - bent[t[0]])[2] / 2;
    TEST_COMPARE(part, >, 0);
    sum += part;
  }
  TEST_FLOATING_EQUALITY(sum, 3.0, 1e-15);
}

// A hole as files draw it that know no holes: along a bridge to it, around, and back.
TEUCHOS_UNIT_TEST(Polygon, TrianglesLeaveOutAHoleThatABridgeLeadsTo) {
  const std::vector<Vector<3>> outer{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}},
      hole{{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  for (int from = 0; from < 4; ++from)
    for (int to = 0; to < 4; ++to) {
      std::vector<Vector<3>> keyhole;
      for (int k = 0; k <= 4; ++k) keyhole.push_back(outer[(from + k) % 4]);
      for (int k = 0; k <= 4; ++k) keyhole.push_back(hole[(to + k) % 4]);
      // Only bridges that stay outside of the hole are drawn by anyone.
      const auto bridge = hole[to] - outer[from];
      if (std::abs(bridge[0]) > 1.5 || std::abs(bridge[1]) > 1.5) continue;
      double sum = 0;
      for (const auto& t : cut_into_triangles(keyhole)) {
        const auto &a = keyhole[t[0]], &b = keyhole[t[1]], &c = keyhole[t[2]];
        const double part = cross(b - a, c - a)[2] / 2;
        TEST_COMPARE(part, >=, 0);
        const auto middle = (1.0 / 3) * (a + b + c);
        if (part > 0) TEST_ASSERT(std::max(std::abs(middle[0] - 1.5), std::abs(middle[1] - 1.5)) > 0.5);
        sum += part;
      }
      TEST_FLOATING_EQUALITY(sum, 8.0, 1e-14);
    }
}

// Both stones of a warped joint must choose the same diagonal, from wherever they begin and whichever way they go.
TEUCHOS_UNIT_TEST(Polygon, ASaddleIsCutAlikeFromEitherSide) {
  const std::vector<Vector<3>> saddle{{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}};
  const auto diagonal = [](const std::vector<Vector<3>>& p) {
    const auto t = cut_into_triangles(p);
    std::vector<Vector<3>> ends;
    for (const int corner : t[0])
      for (const int other : t[1])
        if (corner == other) ends.push_back(p[corner]);
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  auto other = saddle;
  for (int turns = 0; turns < 4; ++turns) {
    std::rotate(other.begin(), other.begin() + 1, other.end());
    TEST_ASSERT(diagonal(other) == diagonal(saddle));
    TEST_ASSERT(diagonal({other.rbegin(), other.rend()}) == diagonal(saddle));
  }
}

TEUCHOS_UNIT_TEST(Polygon, ABorderThatTouchesItselfIsLoopsThatDoNot) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  TEST_ASSERT((loops_apart(square) == std::vector<std::vector<int>>{{0, 1, 2, 3}}));
  // A hole that touches the corner at the origin, and another that touches that hole.
  const Polygon touched{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 3}, {2, 4}, {4, 4}, {2, 4}, {3, 1}};
  const auto loops = loops_apart(touched);
  TEST_EQUALITY(loops.size(), 3u);
  TEST_ASSERT((loops[0] == std::vector<int>{0, 1, 2, 3}));
  TEST_ASSERT((loops[1] == std::vector<int>{6, 7}));  // an edge there and back
  TEST_ASSERT((loops[2] == std::vector<int>{4, 5, 8, 9}));
}

}  // namespace
