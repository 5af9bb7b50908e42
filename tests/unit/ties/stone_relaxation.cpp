// Stones between springs with a law, by hand.
//
// Set-up    One stone of 0.5 m on the ground, two of 0.25 m on it side by side, all 0.25 m high.
#include "ties/stone_relaxation.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double weight = 1000, spring = 1e6, ground = 1e12;  // [N], [N/m] of points and of what holds block 0

std::vector<Stone<2>> stones_of(const PlaneModel& model) {
  const auto& s = model.structure();
  std::vector<Stone<2>> stones;
  for (const auto& block : s.blocks()) {
    Stone<2> stone;
    const auto count = static_cast<int>(block.mesh.position.size());
    for (int n = 0; n < count; ++n) stone.middle = stone.middle + (1.0 / count) * s.position()[block.first_local + n];
    for (int n = 0; n < count; ++n)
      stone.radius = std::max(stone.radius, norm(s.position()[block.first_local + n] - stone.middle));
    if (block.mesh.id == 0) stone.support = {ground, ground, ground};
    stones.push_back(stone);
  }
  return stones;
}

/// Beds that press as they are told, and a joint between the half stones that stands open by more than they move.
/// Stones lack what they are given here, by block.
struct Relaxed {
  Experiment wall{tied_wall()};
  const PlaneModel& model = wall.model();
  StoneRelaxation<2> stones{model, stones_of(model), spring};
  std::vector<StoneVector<2>> lacks;

  explicit Relaxed(const std::vector<StoneVector<2>>& lack_of_block, double pressed = 0) {
    const auto& s = model.structure();
    for (int b = 0; b < s.owned_blocks(); ++b) lacks.push_back(lack_of_block[s.blocks()[b].mesh.id]);
    begin(pressed);
  }
  void begin(double pressed) {
    std::vector<StonePoint<2>> points(model.points().size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool bed = joint_of(model, static_cast<int>(k)).block_i == 0;
      points[k] = {{0.6, 0, 0}, {bed ? pressed : 0.0, 0}, bed ? 0.0 : 1e3};
    }
    stones.begin(points, lacks);
  }
  /// What a block lacks alone where it lacks least [N]; over all ranks.
  double alone(BlockId block, double bearable) {
    const int b = model.structure().local_block(block);
    const bool mine = b >= 0 && b < model.structure().owned_blocks();
    return largest_over_ranks(*model.structure().comm(), mine ? stones.alone(b, lacks[b], bearable) : 0.0);
  }
  double passing(BlockId block) const {
    const int b = model.structure().local_block(block);
    const bool mine = b >= 0 && b < model.structure().owned_blocks();
    return largest_over_ranks(*model.structure().comm(), mine ? stones.passing(b) : 0.0);
  }
  RelaxedStones relax(double bearable) { return stones.relax(std::vector<double>(lacks.size(), bearable), 0); }
  /// The most that any stone of any rank lacks [N].
  double most(const RelaxedStones& relaxed) const {
    double mine = 0;
    for (const double lack : relaxed.lacks) mine = std::max(mine, lack);
    return largest_over_ranks(*model.structure().comm(), mine);
  }
};

constexpr double little = 1e-3 * weight;

TEUCHOS_UNIT_TEST(StoneRelaxation, AStoneThatIsPressedOnAnotherFindsBalanceAndOneThatIsLiftedNone) {
  Relaxed wall({{}, {0, -weight, 0}, {0, weight, 0}});
  TEST_COMPARE(wall.alone(1, little), <=, little);
  TEST_FLOATING_EQUALITY(wall.alone(2, little), weight, 1e-12);  // nothing draws it back, wherever it goes
}

TEUCHOS_UNIT_TEST(StoneRelaxation, AsksNothingOfAStoneThatLacksNoMoreThanItMay) {
  Relaxed wall({{}, {0, weight, 0}, {}});
  TEST_EQUALITY(wall.alone(1, weight), weight);
  TEST_EQUALITY(wall.alone(1, 2 * weight), weight);
}

// The joint below a half stone has three points; those of both halves and none beside press with 100 N each.
TEUCHOS_UNIT_TEST(StoneRelaxation, HalfOfTheForcesOfItsPointsPassesThroughAStone) {
  const Relaxed wall({{}, {}, {}}, 100);
  TEST_FLOATING_EQUALITY(wall.passing(1), 150.0, 1e-14);
  TEST_FLOATING_EQUALITY(wall.passing(0), 300.0, 1e-14);
}

// Three points that press with 500 N each bear 900 N of friction: of 600 N all, of 2000 N not even those that the
// stone's tipping adds.
TEUCHOS_UNIT_TEST(StoneRelaxation, FrictionBearsWhatItsPressureLets) {
  Relaxed held({{}, {-600, 0, 0}, {}}, 500);
  TEST_COMPARE(held.alone(1, little), <=, little);
  Relaxed slides({{}, {-2000, 0, 0}, {}}, 500);
  TEST_COMPARE(slides.alone(1, little), >, 500);
}

TEUCHOS_UNIT_TEST(StoneRelaxation, AllStonesTogetherFindBalanceOrTellThatOneIsLoose) {
  Relaxed standing({{}, {0, -weight, 0}, {0, -weight, 0}});
  const auto at_rest = standing.relax(little);
  TEST_ASSERT(!at_rest.any_loose);
  TEST_COMPARE(standing.most(at_rest), <=, little);
  Relaxed hanging({{}, {0, -weight, 0}, {0, weight, 0}});
  const auto lifted = hanging.relax(little);
  TEST_ASSERT(lifted.any_loose);
  TEST_FLOATING_EQUALITY(hanging.most(lifted), weight, 1e-6);
}

TEUCHOS_UNIT_TEST(StoneRelaxation, BalanceThatWasFoundIsFoundAgainUnderTheSameForces) {
  Relaxed standing({{}, {0, -weight, 0}, {0, -weight, 0}});
  const auto first = standing.relax(little);
  standing.begin(0);
  const auto again = standing.relax(little);
  TEST_ASSERT(!again.any_loose);
  TEST_COMPARE_ARRAYS(again.lacks, first.lacks);  // where the stones were, not where another search would end
}

}  // namespace
