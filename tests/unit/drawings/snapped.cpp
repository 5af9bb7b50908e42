// Welding and splitting in the plane against answers by hand, and what does not fit by stone and place.
#include "drawings/snapped.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "unit/drawings/drawn_walls.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;
using Kind = SnapFault::Kind;

SnappedStones fitted(std::vector<OutlinedStone> stones, double snap, double reach = 0) {
  check_outlines("a.csv", stones);
  return snapped(stones, snap, reach > 0 ? reach : 2 * snap);
}

const SnapFault& only_fault(const SnappedStones& s) {
  static const SnapFault none;
  return s.faults.size() == 1 ? s.faults[0] : none;
}

TEUCHOS_UNIT_TEST(Snapped, CornersMeetInTheirMeanAndTheLargestMoveIsTold) {
  // Corners (1, 0) and (1.004, 0) meet at 1.002, (1, 1) and (1, 1.002) at 1.001.
  const auto s = fitted({stone("a", box(0, 0, 1, 1)), stone("b", {{1.004, 0}, {2, 0}, {2, 1}, {1, 1.002}})}, 0.005);
  TEST_ASSERT(s.faults.empty());
  TEST_EQUALITY(s.corners, 8);
  TEST_EQUALITY(s.points.size(), 6u);
  TEST_COMPARE(norm(s.points[1] - Vector<2>{1.002, 0}), <, 1e-15);
  TEST_COMPARE(norm(s.points[2] - Vector<2>{1, 1.001}), <, 1e-15);
  TEST_FLOATING_EQUALITY(s.farthest, 0.002, 1e-12);
  TEST_EQUALITY(s.moved_stone, 0);
  TEST_ASSERT(s.joints == (std::vector<std::array<int, 2>>{{0, 1}}));
  TEST_FLOATING_EQUALITY(s.joint_length, norm(Vector<2>{0.002, 1.001}), 1e-12);
}

TEUCHOS_UNIT_TEST(Snapped, WhatIsDrawnExactlyIsNotMovedByABit) {
  const auto s = fitted(bond(3, 3, 0.3, 0.1), 1e-4);
  TEST_ASSERT(s.faults.empty());
  TEST_EQUALITY(s.farthest, 0.0);
  // Three whole stones, two and two halves, three: 2 + 3 + 2 head joints, and six beds between two courses.
  TEST_EQUALITY(s.joints.size(), 2u + 3u + 2u + 6u + 6u);
  TEST_FLOATING_EQUALITY(s.joint_length, 7 * 0.1 + 2 * 0.9, 1e-12);
}

TEUCHOS_UNIT_TEST(Snapped, AnEdgeIsSplitWhereACornerOfAnotherStoneLiesOnIt) {
  // The corners of b and c lie 1 mm above and 2 mm below the top edge of a: at their mean, 0.5 mm below.
  const auto s = fitted({stone("a", box(0, 0, 2, 1)), stone("b", {{0, 1}, {1, 1.001}, {1, 2}, {0, 2}}),
                         stone("c", {{1, 0.998}, {2, 1}, {2, 2}, {1, 2}})},
                        0.004);
  TEST_ASSERT(s.faults.empty());
  TEST_EQUALITY(s.cuts, 1);
  TEST_EQUALITY(s.loops[0][0].size(), 5u);
  TEST_EQUALITY(s.joints.size(), 3u);
  TEST_COMPARE(norm(s.points[s.loops[0][0][3]] - Vector<2>{1, 0.9995}), <, 1e-15);
}

TEUCHOS_UNIT_TEST(Snapped, HolesAreClockwiseAndAStoneMayFillOne) {
  auto hole = box(1, 1, 1, 1);
  const auto s = fitted({stone("frame", box(0, 0, 3, 3), {hole}), stone("heart", hole)}, 0.01);
  TEST_ASSERT(s.faults.empty());
  TEST_EQUALITY(s.joints.size(), 1u);
  TEST_FLOATING_EQUALITY(s.joint_length, 4.0, 1e-14);
}

TEUCHOS_UNIT_TEST(Snapped, StonesThatLieInEachOtherAreFoundWithDepthAndPlace) {
  const auto crossing = fitted({stone("a", box(0, 0, 1, 1)), stone("b", box(0.9, 0.2, 1, 0.5))}, 0.01);
  TEST_ASSERT(only_fault(crossing).kind == Kind::overlap);
  TEST_FLOATING_EQUALITY(only_fault(crossing).size, 0.1, 1e-12);
  TEST_COMPARE(std::abs(only_fault(crossing).place[0] - 0.95), <, 0.051);  // either end of the overlap
  // Without edges that cross: one in the other, and two on one side of an edge.
  const auto within = fitted({stone("a", box(0, 0, 1, 1)), stone("b", box(0.3, 0.3, 0.2, 0.2))}, 0.01);
  TEST_ASSERT(only_fault(within).kind == Kind::overlap);
  const auto flush = fitted({stone("a", box(0, 0, 1, 1)), stone("b", box(0, 0, 1, 0.4))}, 0.01);
  TEST_ASSERT(only_fault(flush).kind == Kind::overlap);
  TEST_EQUALITY(only_fault(flush).other, 1);
  const auto twice = fitted({stone("a", box(0, 0, 1, 1)), stone("b", box(0, 0.001, 1, 1))}, 0.01);
  TEST_ASSERT(only_fault(twice).kind == Kind::twice);
}

TEUCHOS_UNIT_TEST(Snapped, SmallGapsAreFoundAndOpenOnesAreNot) {
  const std::vector<OutlinedStone> stones{stone("a", box(0, 0, 1, 1)), stone("b", box(1.02, 0, 1, 1))};
  const auto gap = fitted(stones, 0.005, 0.05);
  TEST_ASSERT(only_fault(gap).kind == Kind::gap);
  TEST_FLOATING_EQUALITY(only_fault(gap).size, 0.02, 1e-12);
  TEST_ASSERT(fitted(stones, 0.005, 0.015).faults.empty());
  // Two stones on a third that lean apart from their common foot: meant so.
  const auto wedge = fitted({stone("a", box(0, 0, 2, 1)), stone("b", {{0, 1}, {1, 1}, {0.7, 2}, {0, 2}}),
                             stone("c", {{1, 1}, {2, 1}, {2, 2}, {1.3, 2}, {1.02, 1.05}})},
                            0.001, 0.08);
  TEST_ASSERT(wedge.faults.empty());
}

TEUCHOS_UNIT_TEST(Snapped, AStoneThatIsNarrowerThanTheToleranceIsASliver) {
  const auto sliver = fitted({stone("a", box(0, 0, 1, 1)), stone("b", box(2, 0, 1, 0.005))}, 0.01);
  TEST_ASSERT(!sliver.faults.empty() && sliver.faults[0].kind == Kind::sliver);
  TEST_EQUALITY(sliver.faults[0].stone, 1);
  const auto neck = fitted({stone("a", {{0, 0}, {1, 0}, {1, 0.49}, {2, 0}, {2, 1}, {1, 0.495}, {1, 1}, {0, 1}})}, 0.01);
  TEST_ASSERT(!neck.faults.empty() && neck.faults[0].kind == Kind::sliver);
  TEST_COMPARE(std::abs(neck.faults[0].place[0] - 1), <, 1e-12);
}

TEUCHOS_UNIT_TEST(Outlines, WhatIsNoOutlineIsToldByStoneAndPlace) {
  const auto error = [](std::vector<OutlinedStone> stones) {
    return input_error([&] { check_outlines("a.csv", stones); });
  };
  const auto bow = error({stone("good", box(0, 0, 1, 1)), stone("bow", {{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  TEST_ASSERT(test::holds(bow, "1 of 2 stones has no outline"));
  TEST_ASSERT(test::holds(bow, "stone \"bow\" (drawn) at (1, 1) crosses itself at (1, 1)"));
  TEST_ASSERT(test::holds(error({stone("line", {{0, 0}, {1, 1}, {2, 2}})}), "has no area"));
  TEST_ASSERT(test::holds(error({stone("two", {{0, 0}, {1, 1}, {1, 1}, {0, 0}})}), "has 2 corners"));
  TEST_ASSERT(test::holds(error({stone("far", {{0, 0}, {1, 1}, {1e12, 1}})}), "farther than 1e9 m"));
  TEST_ASSERT(test::holds(error({stone("out", box(0, 0, 1, 1), {box(3, 3, 1, 1)})}), "lies outside of its outline"));
  std::vector<OutlinedStone> clockwise{stone("c", {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}})};
  check_outlines("a.csv", clockwise);
  TEST_EQUALITY(clockwise[0].loops[0].corners.size(), 4u);
  TEST_FLOATING_EQUALITY(area(clockwise[0].loops[0].corners), 1.0, 1e-15);
}

}  // namespace
