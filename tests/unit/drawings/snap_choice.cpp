// The tolerance that is chosen fits the drawing, whatever its noise and unit; what a user is told of it.
#include "drawings/snap_choice.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "unit/drawings/drawn_walls.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

std::string all_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

TEUCHOS_UNIT_TEST(SnapChoice, SurveysFitAtWhatTheirNoiseAsksFor) {
  // Courses of four and of three and two halves: heads 3 and 4 each, beds 8 between two courses.
  const std::size_t joints = 3 * (3 + 4) + 5 * 8;
  for (const double noise : {0.0, 1e-6, 1e-4, 1e-3, 5e-3})
    for (const unsigned seed : {1u, 2u, 3u}) {
      const auto s = plane_stones_of(file_of(bond(6, 4, 0.6, 0.3, noise, seed)), asked());
      TEST_EQUALITY(s.snapped.joints.size(), joints);
      TEST_COMPARE(s.snap, >, noise);
      TEST_COMPARE(s.snapped.farthest, <=, 3 * noise);
    }
}

TEUCHOS_UNIT_TEST(SnapChoice, TheRowsOfToleranceAreTold) {
  const auto s = plane_stones_of(file_of(bond(6, 4, 0.6, 0.3, 5e-3)), asked());
  const auto text = all_of(s.report);
  TEST_ASSERT(test::holds(text, "joints by snap: "));
  TEST_ASSERT(test::holds(text, "from the middle of the widest range that fits"));
  TEST_ASSERT(test::holds(text, "moved by up to 0.00"));
  TEST_ASSERT(test::holds(text, "27 stones, 4.3"));
}

TEUCHOS_UNIT_TEST(SnapChoice, AToleranceThatIsTooSmallOrTooLargeIsRefusedWithWhatToDo) {
  const auto error = [](double snap) {
    return input_error([&] { plane_stones_of(file_of(bond(6, 4, 0.6, 0.3, 5e-3)), asked(snap)); });
  };
  const auto small = error(2e-3);
  TEST_ASSERT(test::holds(small, "stones do not fit together, with snap = 0.002 m"));
  TEST_ASSERT(test::holds(small, "(drawn) at ("));
  TEST_ASSERT(test::holds(small, "raise mesh > stones > snap above 0.0"));
  TEST_ASSERT(test::holds(small, "the drawing fits with 61 joints"));
  const auto large = error(0.4);
  TEST_ASSERT(test::holds(large, "is somewhere narrower than snap"));
  TEST_ASSERT(test::holds(large, "Lower mesh > stones > snap"));
  TEST_ASSERT(test::holds(error(1e-16), "less than the round-off"));
}

TEUCHOS_UNIT_TEST(SnapChoice, NamesOfStonesAndSetsMustNotMeet) {
  auto stones = bond(1, 2, 1, 1);
  stones[1].name = stones[0].name;
  const auto error = [&] { return input_error([&] { plane_stones_of(file_of(stones), asked()); }); };
  TEST_ASSERT(test::holds(error(), "have one name"));
  stones[1].name = "b";
  stones[1].sets = {stones[0].name};
  TEST_ASSERT(test::holds(error(), "and another stone is called so"));
  stones[1].sets = {"all"};
  TEST_ASSERT(test::holds(error(), "always means every stone"));
  stones[1].sets = {"b"};
  TEST_ASSERT(error().empty());
}

TEUCHOS_UNIT_TEST(SnapChoice, TheAxisThatPointsUpAndTheUnitArePutRight) {
  auto p = asked();
  p.unit = 0.1;
  p.up = UpAxis::minus_y;
  const auto down = plane_stones_of(file_of({stone("a", {{0, 0}, {20, 0}, {20, 10}})}), p);
  TEST_COMPARE(norm(middle_of(down.stones[0]) - Vector<2>{4.0 / 3, -1.0 / 3}), <, 1e-15);
  p.up = UpAxis::x;
  const auto turned = plane_stones_of(file_of({stone("a", {{0, 0}, {20, 0}, {20, 10}})}), p);
  TEST_COMPARE(norm(middle_of(turned.stones[0]) - Vector<2>{-1.0 / 3, 4.0 / 3}), <, 1e-15);
  auto file = file_of({stone("a", box(0, 0, 1, 1))});
  file.unit = 1e-3;
  file.unused = {"3 TEXT"};
  const auto told = plane_stones_of(file, asked());
  TEST_EQUALITY(told.warnings.size(), 2u);
  TEST_EQUALITY(told.warnings[1].what, "drawing_unit");
}

}  // namespace
