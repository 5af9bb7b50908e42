// Whether a step is one that the model can tell, by hand: slips, turns, stones in each other.
//
// Set-up    One stone of 0.5 m on the ground, two of 0.25 m on it side by side, all 0.25 m high, in cells of 0.125 m.
//           Block 2, on the right, is moved; the points below it press as a test says, all others bear nothing.
#include <Teuchos_UnitTestHarness.hpp>
#include <array>
#include <functional>

#include "model/plane/plane_model.hpp"
#include "range/plane/measures.hpp"
#include "range/plane/slip_range.hpp"
#include "range/plane/stone_overlap.hpp"
#include "range/turn_range.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double cell = 0.125, height = 0.25, length = 0.25, friction = 0.6;  // [m], [m], [m], [-]
constexpr Vector<2> middle{0.375, 0.375};                                     // [m] of block 2

struct Moved {
  Experiment wall{tied_wall()};
  const PlaneModel& model = wall.model();
  ContactState state = wall.state();
  std::vector<double> load;

  /// @param presses  [N] at the points below block 2, from left to right
  explicit Moved(const std::array<double, 3>& presses) : load(state.displacement.size(), 0.0) {
    for (int k = 0; k < model.points().size(); ++k) {
      const auto& joint = joint_of(model, k);
      if (joint.block_i != 0 || joint.block_j != 2) continue;
      const double x = model.structure().position()[model.points().points()[k].shares_i.first()][0];
      state.lambda[2 * k] = presses[static_cast<std::size_t>(std::lround((x - 0.25) / cell))];
    }
  }
  void move(const std::function<Vector<2>(const Vector<2>&)>& motion) {
    const auto& s = model.structure();
    for (int n = 0; n < s.nodes(); ++n) {
      if (s.blocks()[s.block_of_node()[n]].mesh.id != 2) continue;
      const auto u = motion(s.position()[n]);
      std::copy_n(u.begin(), 2, state.displacement.begin() + 2 * n);
    }
  }
  StepEnd end() const { return {state, load, model.absent(), "a step"}; }
};

RangeFindings slip(double right, const std::array<double, 3>& presses) {
  Moved moved(presses);
  moved.move([&](const Vector<2>&) { return Vector<2>{right, 0}; });
  return look_at_slips(moved.model, moved.end());
}

TEUCHOS_UNIT_TEST(RangeOfSlips, IsLeftWhereAPointThatPressesSlipsBeyondItsCell) {
  TEST_ASSERT(slip(0.99 * cell, {0, 10, 0}).warnings.empty());
  TEST_ASSERT(slip(1.01 * cell, {0, 0, 0}).warnings.empty());  // what bears nothing may go where it likes
  const auto found = slip(1.01 * cell, {0, 10, 0});
  TEST_EQUALITY(found.warnings.size(), 1);
  TEST_EQUALITY(found.warnings.front().what, "slip_beyond_cell");
  TEST_FLOATING_EQUALITY(found.warnings.front().how_much, 1.01 * cell, 1e-12);
  TEST_ASSERT(found.out_of_range.empty());  // both faces still reach there
}

// By 0.3 m the stone has left the face below it.
TEUCHOS_UNIT_TEST(RangeOfSlips, CannotBeToldWhereTheForceHasLeftTheFaces) {
  const auto found = slip(0.3, {0, 10, 0});
  TEST_EQUALITY(found.warnings.size(), 1);
  TEST_ASSERT(found.out_of_range.find("100 % of its force") != std::string::npos);
}

RangeFindings turn(double angle, const std::array<double, 3>& presses = {10, 10, 10}) {
  Moved moved(presses);
  moved.move([&](const Vector<2>& x) {
    const auto arm = x - middle;
    return Vector<2>{-angle * arm[1], angle * arm[0]};
  });
  return look_at_turns(moved.model, moved.end(), length / 2);
}

// A stone on its bed topples at the angle length / height; of that it has turned by a share.
TEUCHOS_UNIT_TEST(RangeOfTurns, IsMeasuredByTheAngleAtWhichAStoneTopples) {
  const double topples = length / height;
  TEST_ASSERT(turn(0.05 * topples).warnings.empty());
  const auto found = turn(0.2 * topples);
  TEST_EQUALITY(found.warnings.size(), 1);
  TEST_EQUALITY(found.warnings.front().what, "turn_beyond_first_order");
  TEST_FLOATING_EQUALITY(found.warnings.front().how_much, 0.2, 1e-5);
  TEST_ASSERT(found.out_of_range.empty());
  TEST_ASSERT(!turn(1.1 * topples).out_of_range.empty());
  TEST_ASSERT(turn(0.2 * topples, {0, 0, 0}).warnings.empty());  // nothing stands on it
}

RangeFindings lower(double down) {
  Moved moved({10, 10, 10});
  moved.move([&](const Vector<2>&) { return Vector<2>{0, -down}; });
  const std::vector<double> sides(static_cast<std::size_t>(moved.model.structure().owned_blocks()), cell);
  return look_at_outlines(moved.model, moved.end(), sides, cell);
}

TEUCHOS_UNIT_TEST(RangeOfOutlines, IsLeftWhereAStoneLiesInAnotherByMoreThanAHundredthOfACell) {
  TEST_ASSERT(lower(-0.1).warnings.empty());  // lifted
  TEST_ASSERT(lower(0.009 * cell).warnings.empty());
  const auto found = lower(0.02);
  TEST_EQUALITY(found.warnings.size(), 1);
  TEST_EQUALITY(found.warnings.front().what, "stones_overlap");
  TEST_FLOATING_EQUALITY(found.warnings.front().how_much, 0.02, 1e-9);
}

TEUCHOS_UNIT_TEST(RangeCheck, TellsItsWarningsAndWhyAStepIsOutOfRange) {
  Moved moved({10, 10, 10});
  Warnings told;
  RangeCheck check(moved.model, measures_in_plane(moved.model), [&](const Warning& w) { told.push_back(w); });
  TEST_ASSERT(check.beyond(moved.end()).empty());
  TEST_ASSERT(told.empty());
  moved.move([](const Vector<2>&) { return Vector<2>{1.1 * cell, -0.02}; });
  auto end = moved.end();
  end.outlines = false;
  TEST_ASSERT(!check.beyond(end).empty());
  TEST_EQUALITY(told.size(), 1);
  TEST_EQUALITY(told.front().when, "a step");
  end.outlines = true;
  check.beyond(end);
  TEST_EQUALITY(told.back().what, "stones_overlap");
}

}  // namespace
