// Stones are mended without a guess, or refused by name and place.
#include "stones/repair.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>

#include "unit/stones/drawn_stones.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

StoneSurface cube() { return box("cube", {0, 0, 0}, {1, 1, 1}); }

/// Every face with points of its own, as STL has it.
StoneSurface soup(const StoneSurface& stone) {
  StoneSurface apart = stone;
  apart.points.clear();
  for (auto& face : apart.faces)
    for (int& point : face) {
      apart.points.push_back(stone.points[point]);
      point = static_cast<int>(apart.points.size()) - 1;
    }
  return apart;
}

TEUCHOS_UNIT_TEST(Repair, APrismHoldsItsVolumeAndIsClosed) {
  // 3 of the L and 1 of each box, exact in doubles.
  const auto stones = corner();
  TEST_FLOATING_EQUALITY(volume(stones[0]), 3.0, 1e-15);
  TEST_ASSERT(open_edges(stones[0]).none());
  TEST_EQUALITY(closed(stones).stones.size(), 3u);
  TEST_ASSERT(closed(stones).warnings.empty());
}

TEUCHOS_UNIT_TEST(Repair, PointsOnEachOtherAreOne) {
  StoneSurface stone = soup(cube());
  for (std::size_t k = 0; k < stone.points.size(); ++k) stone.points[k][0] += 1e-8 * static_cast<double>(k % 5);
  const auto repaired = closed({stone});
  TEST_EQUALITY(repaired.repairs[0].welded, 16);
  TEST_EQUALITY(repaired.stones[0].points.size(), 8u);
}

TEUCHOS_UNIT_TEST(Repair, TurnedDoubledAndEmptyFacesAreMendedAndTold) {
  StoneSurface stone = cube();
  std::reverse(stone.faces[1].begin(), stone.faces[1].end());
  stone.faces.push_back(stone.faces[2]);
  std::reverse(stone.faces.back().begin(), stone.faces.back().end());
  stone.faces.push_back({0, 1, 0});
  const auto repaired = closed({stone});
  TEST_EQUALITY(repaired.repairs[0].turned, 1);
  TEST_EQUALITY(repaired.repairs[0].doubled, 1);
  TEST_EQUALITY(repaired.repairs[0].no_area, 1);
  TEST_EQUALITY(repaired.warnings.size(), 3u);
  TEST_FLOATING_EQUALITY(volume(repaired.stones[0]), 1.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Repair, AStoneInsideOutIsTurnedWhole) {
  StoneSurface stone = cube();
  for (auto& face : stone.faces) std::reverse(face.begin(), face.end());
  const auto repaired = closed({stone});
  TEST_EQUALITY(repaired.repairs[0].turned, 6);
  TEST_FLOATING_EQUALITY(volume(repaired.stones[0]), 1.0, 1e-15);
  TEST_EQUALITY(repaired.warnings.at(0).what, "faces_turned");
}

TEUCHOS_UNIT_TEST(Repair, AMissingFaceIsRefusedWithItsEdges) {
  StoneSurface stone = cube();
  stone.faces.pop_back();
  const auto error = input_error([&] { closed({cube(), stone}); });
  TEST_ASSERT(holds(error, "1 of 2 stones"));
  TEST_ASSERT(holds(error, "stone \"cube\" (drawn) is not closed: 4 edges of one face only"));
}

TEUCHOS_UNIT_TEST(Repair, TwoStonesInOneGroupAreTwoUnlessTheyShareAnEdge) {
  const auto group = [](const Vector<3>& low) {
    StoneSurface stone = cube();
    const StoneSurface other = box("", low, low + Vector<3>{1, 1, 1});
    for (const auto& face : other.faces) {
      stone.faces.push_back(face);
      for (int& point : stone.faces.back()) point += 8;
    }
    stone.points.insert(stone.points.end(), other.points.begin(), other.points.end());
    return stone;
  };
  const auto apart = closed({group({3, 0, 0})});
  TEST_EQUALITY(apart.stones.size(), 2u);
  TEST_EQUALITY(apart.stones[1].name, "cube part 2");
  TEST_EQUALITY(apart.warnings.at(0).what, "stones_in_one_group");
  TEST_ASSERT(holds(input_error([&] { closed({group({1, 1, 0})}); }), "1 edge of more than two faces"));
}

TEUCHOS_UNIT_TEST(Repair, ASheetHoldsNoVolume) {
  StoneSurface sheet = cube();
  for (auto& x : sheet.points) x[2] = 0;
  TEST_ASSERT(!input_error([&] { closed({sheet}); }).empty());
}

TEUCHOS_UNIT_TEST(Repair, AHollowStoneIsRefusedAsOne) {
  auto hollow = box("hollow", {0, 0, 0}, {1, 1, 1});
  const auto inner = box("", {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  for (auto face : inner.faces) {
    for (int& point : face) point += 8;
    hollow.faces.push_back(face);
  }
  hollow.points.insert(hollow.points.end(), inner.points.begin(), inner.points.end());
  const std::string refused = input_error([&] { closed({hollow}); });
  TEST_ASSERT(holds(refused, "stone \"hollow\" (drawn) has a closed surface within another, at (0.3, 0.3, 0.3) m"));
  TEST_ASSERT(holds(refused, "cavity"));
}

TEUCHOS_UNIT_TEST(Repair, CornersThatAreNearlyInOnePlaceAreWeldedWhereThatIsAsked) {
  StoneSurface soup;
  soup.name = "soup";
  const auto cube = box("", {0, 0, 0}, {1, 1, 1});
  int number = 0;
  for (const auto& face : cube.faces) {
    soup.faces.emplace_back();
    for (const int point : face) {
      soup.faces.back().push_back(number);
      soup.points.push_back(cube.points[point] + Vector<3>{1e-4 * (number++ % 3), 0, 0});
    }
  }
  TEST_ASSERT(holds(input_error([&] { closed({soup}); }), "give mesh > stones > weld"));
  const auto mended = closed({soup}, 1e-3);
  TEST_EQUALITY(mended.stones.size(), 1u);
  TEST_EQUALITY(mended.stones[0].points.size(), 8u);
  TEST_FLOATING_EQUALITY(volume(mended.stones[0]), 1.0, 1e-3);
}

}  // namespace
