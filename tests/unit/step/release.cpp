// Which tied points become contact points.
#include "step/release.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <array>
#include <functional>

#include "linalg/reduce.hpp"
#include "model/plane/plane_model.hpp"
#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// A tied wall of which all points are drawn apart with 1 N.
struct Drawn {
  Experiment wall;
  ContactState& state;

  explicit Drawn(const Scene& scene) : wall(scene), state(wall.state()) {
    for (std::size_t i = 0; i < state.lambda.size(); i += 2) state.lambda[i] = -1;
  }
  const PlaneModel& model() const { return wall.model(); }
  /// Over all ranks: how many points between two blocks are selected, of how many.
  std::array<long long, 2> selected_between(BlockId i, BlockId j) const {
    std::array<long long, 2> count{0, 0};
    for (int k = 0; k < model().points().owned(); ++k) {
      const auto& joint = joint_of(model(), k);
      if (joint.block_i != i || joint.block_j != j) continue;
      count[0] += state.selected[k];
      ++count[1];
    }
    for (auto& n : count) n = total_over_ranks(*model().structure().comm(), n);
    return count;
  }
  /// Forces of selected points became admissible, those of others are as they were.
  bool only_selected_were_admitted() const {
    for (std::size_t k = 0; k < state.selected.size(); ++k)
      if (state.lambda[2 * k] != (state.selected[k] ? 0.0 : -1.0)) return false;
    return true;
  }
  long long release_by(const std::function<double(const Joint&, int point)>& decrease) {
    std::vector<double> eta;
    for (int k = 0; k < model().points().owned(); ++k) eta.push_back(decrease(joint_of(model(), k), k));
    return release(model(), model().law(), clusters(model(), state.selected), eta, state);
  }
};

// Of a decrease of 0.8 J at one joint and 0.2 J at another the share 0.7 is found at the first.
TEUCHOS_UNIT_TEST(Release, AJointThatHoldsTheShareIsReleasedAsAWhole) {
  Scene scene = tied_wall();
  scene.selection.bulk = 0.7;
  Drawn wall(scene);
  const auto released = wall.release_by(
      [&](const Joint& joint, int) { return joint.block_i == 0 ? (joint.block_j == 1 ? 0.8 : 0.2) : 0.0; });
  TEST_COMPARE(released, >, 0);
  TEST_EQUALITY(wall.selected_between(0, 1)[0], wall.selected_between(0, 1)[1]);
  TEST_EQUALITY(wall.selected_between(0, 2)[0], 0);
  TEST_EQUALITY(wall.selected_between(1, 2)[0], 0);
  TEST_EQUALITY(released, wall.selected_between(0, 1)[0]);
  TEST_EQUALITY(count_selected(wall.model(), wall.state), released);
  TEST_ASSERT(wall.only_selected_were_admitted());
}

TEUCHOS_UNIT_TEST(Release, WithoutATolerancePointsThatViolateAtAllAreReleasedEachAlone) {
  Scene scene = tied_wall();
  scene.selection.error_tolerance = 0;
  scene.selection.bulk = 0.1;
  scene.selection.whole_joints = false;
  Drawn wall(scene);
  const auto released = wall.release_by([&](const Joint& joint, int k) {
    const bool at_the_end = wall.model().points().points()[k].place[0] == 0;
    return joint.block_i != 0 || joint.block_j != 1 ? 0.0 : at_the_end ? 1e6 : 1.0;
  });
  TEST_EQUALITY(released, wall.selected_between(0, 1)[1]);
  TEST_EQUALITY(wall.selected_between(0, 2)[0] + wall.selected_between(1, 2)[0], 0);
}

TEUCHOS_UNIT_TEST(Release, WhereNothingViolatesNothingIsReleased) {
  Drawn wall(tied_wall());
  TEST_EQUALITY(wall.release_by([](const Joint&, int) { return 0.0; }), 0);
  TEST_ASSERT(wall.only_selected_were_admitted());
}

TEUCHOS_UNIT_TEST(Release, ABlockIsReleasedFromAllItsNeighbours) {
  Drawn wall(tied_wall());
  const auto& blocks = wall.model().structure().blocks();
  std::vector<char> marked;
  for (const auto& block : blocks) marked.push_back(block.mesh.id == 2);
  const auto released = release_blocks(wall.model(), wall.model().law(), marked, wall.state);
  TEST_EQUALITY(wall.selected_between(0, 1)[0], 0);
  TEST_EQUALITY(released, wall.selected_between(0, 2)[1] + wall.selected_between(1, 2)[1]);
  TEST_ASSERT(wall.only_selected_were_admitted());
  TEST_EQUALITY(release_blocks(wall.model(), wall.model().law(), marked, wall.state), 0);
}

TEUCHOS_UNIT_TEST(Release, AllAreReleasedOnce) {
  Drawn wall(tied_wall());
  TEST_ASSERT(release_all(wall.model(), wall.model().law(), wall.state));
  TEST_EQUALITY(count_selected(wall.model(), wall.state), wall.model().points().total());
  TEST_ASSERT(wall.only_selected_were_admitted());
  TEST_ASSERT(!release_all(wall.model(), wall.model().law(), wall.state));
}

TEUCHOS_UNIT_TEST(Release, OnlyMortarIsReleasedAsMortar) {
  Drawn dry(tied_wall());
  TEST_ASSERT(!release_mortar(dry.model(), dry.model().law(), dry.state));
  Scene scene = tied_wall();
  scene.joints[0].parameters.normal_stiffness = 1e9;
  Drawn laid(scene);
  TEST_ASSERT(release_mortar(laid.model(), laid.model().law(), laid.state));
  TEST_EQUALITY(count_selected(laid.model(), laid.state), laid.model().points().total());
}

}  // namespace
