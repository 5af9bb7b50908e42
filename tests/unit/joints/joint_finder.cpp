// Points two blocks have in common: pairs, normals, areas, corners.
#include "joints/joint_finder.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "unit/blocks/lattice_block.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double h = 0.25;  // side of a cell [m]

std::vector<PointOfTwoBlocks> joint(const Block<2>& i, const Block<2>& j) {
  return points_of_joint(i, border_facets<2>({i}), j, border_facets<2>({j}));
}

double length(const std::vector<PointOfTwoBlocks>& points) {
  double sum = 0;
  for (const auto& p : points) sum += p.length;
  return sum;
}

/// Turns everything right of x = 0.5 m clockwise by an angle [degree] about (0.5, 0.5): a joint along y = 0.5 bends.
Block<2> bent(Block<2> block, double degree) {
  const double angle = std::acos(-1.0) / 180 * degree, c = std::cos(angle), s = std::sin(angle);
  for (auto& x : block.position) {
    if (x[0] <= 0.5) continue;
    const Vector<2> d{x[0] - 0.5, x[1] - 0.5};
    x = {0.5 + c * d[0] + s * d[1], 0.5 - s * d[0] + c * d[1]};
  }
  return block;
}

TEUCHOS_UNIT_TEST(JointFinder, TwoSquaresMeetInPointsWhoseNormalsLeaveTheFirst) {
  const auto left = block_of_cells(0, rectangle(0, 0, 2, 2), h), right = block_of_cells(1, rectangle(2, 0, 2, 2), h);
  for (const bool from_left : {true, false}) {
    const auto& i = from_left ? left : right;
    const auto& j = from_left ? right : left;
    const auto points = joint(i, j);
    TEST_EQUALITY(points.size(), 3u);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& p = points[k];
      TEST_EQUALITY(i.vertex[p.node_i], p.vertex);
      TEST_EQUALITY(j.vertex[p.node_j], p.vertex);
      TEST_EQUALITY(p.normal[0], from_left ? 1.0 : -1.0);
      TEST_EQUALITY(p.normal[1], 0.0);
      TEST_EQUALITY(p.length, k == 1 ? h : h / 2);
      if (k > 0) TEST_COMPARE(points[k - 1].vertex, <, p.vertex);
    }
  }
}

TEUCHOS_UNIT_TEST(JointFinder, AJointIsAsLongAsWhatTheBlocksShareAndNoLonger) {
  const auto low = block_of_cells(0, rectangle(0, 0, 5, 1), h), high = block_of_cells(1, rectangle(2, 1, 6, 1), h);
  const auto points = joint(low, high);
  TEST_EQUALITY(points.size(), 4u);
  TEST_FLOATING_EQUALITY(length(points), 3 * h, 1e-15);
  for (const auto& p : points) TEST_ASSERT(p.normal == (Vector<2>{0, 1}));
}

TEUCHOS_UNIT_TEST(JointFinder, ACornerOf90DegreesIsTwoPointsOneForEachSide) {
  // An L of three cells each way, and the square in its notch.
  auto cells = rectangle(0, 0, 4, 1);
  for (const auto& c : rectangle(0, 1, 1, 3)) cells.push_back(c);
  const auto angle = block_of_cells(0, cells, h), square = block_of_cells(1, rectangle(1, 1, 3, 3), h);
  const auto points = joint(angle, square);
  TEST_EQUALITY(points.size(), 8u);
  TEST_FLOATING_EQUALITY(length(points), 6 * h, 1e-15);
  int corners = 0, upwards = 0;
  for (const auto& p : points) {
    const auto& x = angle.position[p.node_i];
    TEST_ASSERT(p.normal == (Vector<2>{1, 0}) || p.normal == (Vector<2>{0, 1}));
    upwards += p.normal[1] == 1;
    if (x == Vector<2>{h, h}) {
      ++corners;
      TEST_EQUALITY(p.length, h / 2);
    }
  }
  TEST_EQUALITY(corners, 2);
  TEST_EQUALITY(upwards, 4);
}

TEUCHOS_UNIT_TEST(JointFinder, AJointThatBendsGentlyHasOnePointAtTheBendAndASharpBendTwo) {
  for (const double degree : {10.0, 19.0, 21.0, 60.0}) {
    const auto low = bent(block_of_cells(0, rectangle(0, 1, 4, 1), h), degree);
    const auto high = bent(block_of_cells(1, rectangle(0, 2, 4, 1), h), degree);
    const auto points = joint(low, high);
    TEST_EQUALITY(points.size(), degree < 20 ? 5u : 6u);
    TEST_FLOATING_EQUALITY(length(points), 4 * h, 1e-14);
    for (const auto& p : points) {
      TEST_FLOATING_EQUALITY(norm(p.normal), 1.0, 1e-15);
      if (degree > 20 || low.position[p.node_i] != Vector<2>{0.5, 0.5}) continue;
      TEST_FLOATING_EQUALITY(p.length, h, 1e-14);  // halves of two edges of equal length: the normal is their mean
      TEST_FLOATING_EQUALITY(std::atan2(p.normal[0], p.normal[1]), std::acos(-1.0) / 180 * degree / 2, 1e-13);
    }
  }
}

TEUCHOS_UNIT_TEST(JointFinder, BlocksThatTouchAtAVertexAloneHaveNoPoints) {
  TEST_EQUALITY(joint(block_of_cells(0, rectangle(0, 0, 2, 2)), block_of_cells(1, rectangle(2, 2, 2, 2))).size(), 0u);
}

}  // namespace
