// Motions of stones as wholes: which ones change no force, whatever the stiffness.
#include "nonlinear/rigid_mechanism.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include "unit/nonlinear/points_alone.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Two points under a stone that moves as a whole, or almost.
class Stone : public Points {
 public:
  Stone() : Points(2, 2), map_(Teuchos::rcp(new TpetraMap(4, 0, Teuchos::DefaultComm<int>::getComm()))) {}
  Teuchos::RCP<const TpetraMap> map() const override { return map_; }
  double rigid_gaps(const TpetraVector&, PointField& gap) override {
    gap = moves;
    return bends;
  }

  PointField moves{0, 0, 0, 0};  ///< gap and slip of each point, of a motion of size 1
  double bends = 0;

 private:
  Teuchos::RCP<const TpetraMap> map_;
};

// 10 N on each point, friction 0.5 spent against a slip to the right (forces oppose slips, so they are negative).
const PointField sliding{10, -5, 10, -5};
constexpr double far = 0.2, allowance = 0.1;  // [m], [N]

bool leads_nowhere(Stone& stone, const PointField& force, const PointField& gap = {0, 0, 0, 0}) {
  const TpetraVector motion(stone.map());
  return is_rigid_mechanism(stone, CurrentLaws(stone), motion, force, gap, far, allowance);
}

TEUCHOS_UNIT_TEST(RigidMechanism, AStoneThatSlidesAgainstFrictionSpentSlidesForEver) {
  Stone stone;
  stone.moves = {1e-9, 1, -1e-9, 1};  // linear solves leave so much
  TEST_ASSERT(leads_nowhere(stone, sliding));
  stone.bends = 1e-3;
  TEST_ASSERT(!leads_nowhere(stone, sliding));
}

TEUCHOS_UNIT_TEST(RigidMechanism, FrictionThatIsNotSpentOrTurnsRoundStopsIt) {
  Stone stone;
  stone.moves = {0, 1, 0, 1};
  TEST_ASSERT(!leads_nowhere(stone, {10, -4, 10, -5}));
  TEST_ASSERT(leads_nowhere(stone, {10, -4.95, 10, -5}));  // within the allowance
  stone.moves = {0, -1, 0, -1};
  TEST_ASSERT(!leads_nowhere(stone, sliding));
  stone.law_.set(1, {std::numeric_limits<double>::infinity()});
  stone.moves = {0, 1, 0, 1};
  TEST_ASSERT(!leads_nowhere(stone, sliding));
}

TEUCHOS_UNIT_TEST(RigidMechanism, WhatPressesNeitherClosesNorOpens) {
  Stone stone;
  stone.moves = {-1e-3, 1, 0, 1};
  TEST_ASSERT(!leads_nowhere(stone, sliding));
  stone.moves = {1e-3, 1, 0, 1};
  TEST_ASSERT(!leads_nowhere(stone, sliding));
}

TEUCHOS_UNIT_TEST(RigidMechanism, AStoneTurnsAboutItsEdgeUntilItMeetsAnother) {
  Stone stone;
  const PointField on_the_edge{10, 2, 0, 0};
  stone.moves = {0, 0, 1, 0.1};
  TEST_ASSERT(leads_nowhere(stone, on_the_edge));
  stone.moves = {0, 0, -1, 0.1};
  TEST_ASSERT(!leads_nowhere(stone, on_the_edge, {0, 0, 0.1, 0}));
  TEST_ASSERT(leads_nowhere(stone, on_the_edge, {0, 0, 0.3, 0}));
}

}  // namespace
