// Damage goes into a solve and comes out of it: a mortared node between springs of 1000 N/m, whose mortar bears 50 N
// and loses 125 N with every metre that it opens, or all as it breaks off. All ends are found by hand.
#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "linalg/local_view.hpp"
#include "nonlinear/contact_solver.hpp"
#include "unit/nonlinear/softening_slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr PointDamage half{0.2, 0.2, 0};  // opened by half of the 0.4 m that take all

struct Solved {
  NewtonReport report;
  double opening, pull;  ///< [m], [N]
  PointDamage damage;
};

Solved solve(const Mortar& mortar, const PointDamage& before, const MethodParameters& methods,
             StrengthIs strength = StrengthIs::falling) {
  Mortared problem(mortar);
  TpetraVector x(problem.map());
  PointField lambda(2, 0.0);
  Damage damage{before};
  FastWay fast;
  ContactSolver solver(problem, {}, methods, fast);
  const auto report = solver.solve({x, lambda, damage}, {1e-10, strength});
  return {report, local_view(x)[1], -lambda[0], damage[0]};
}

/// Active sets are not tried before strength is held and wears.
MethodParameters held_first() {
  MethodParameters methods;
  methods.solver.active_sets = false;
  return methods;
}

void expect_damage(const PointDamage& found, const PointDamage& wanted, Teuchos::FancyOStream& out, bool& success) {
  TEST_FLOATING_EQUALITY(found.opened + 1, wanted.opened + 1, 1e-12);
  TEST_FLOATING_EQUALITY(found.reached + 1, wanted.reached + 1, 1e-12);
  TEST_FLOATING_EQUALITY(found.way + 1, wanted.way + 1, 1e-12);
}

// 1000 g + 50 (1 - 2.5 g) = 80.
TEUCHOS_UNIT_TEST(StrengthThatFalls, WearsDownToWhereActiveSetsArrive) {
  for (const bool held : {false, true}) {
    const auto s = solve({}, {}, held ? held_first() : MethodParameters());
    TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(s.opening, 30.0 / 875, 1e-8);
    TEST_FLOATING_EQUALITY(s.pull, 50 - 125 * 30.0 / 875, 1e-8);
    // Damage that the state itself means is none of the step's start.
    expect_damage(s.damage, {}, out, success);
    TEST_EQUALITY(s.report.lost_on_the_way, 0);
  }
}

// Mortar that falls by 1250 N a metre outruns the springs: nothing is in balance before all is lost.
TEUCHOS_UNIT_TEST(StrengthThatFalls, WearsDownThroughASnap) {
  const Mortar steep{60, 0, {50, 20, false}};
  const auto s = solve(steep, {}, held_first());
  TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
  TEST_FLOATING_EQUALITY(s.opening, 0.06, 1e-8);
  TEST_COMPARE(std::abs(s.pull), <=, 1e-7);
  TEST_EQUALITY(s.report.lost_on_the_way, 0);
}

// 1000 g + 50 = 80: what a look finds where strength is held, which loses nothing.
TEUCHOS_UNIT_TEST(StrengthThatFalls, IsHeldWhereALookAsksForThat) {
  for (const bool held : {false, true}) {
    const auto methods = held ? held_first() : MethodParameters();
    const auto sound = solve({}, {}, methods, StrengthIs::held);
    TEST_ASSERT(sound.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(sound.opening, 0.03, 1e-8);
    TEST_FLOATING_EQUALITY(sound.pull, 50, 1e-8);
    expect_damage(sound.damage, {}, out, success);
    // Half lost, it pulls back by 25 N in 0.2 m: 1125 g = 80.
    const auto worn = solve({}, half, methods, StrengthIs::held);
    TEST_FLOATING_EQUALITY(worn.opening, 80.0 / 1125, 1e-8);
    expect_damage(worn.damage, half, out, success);
  }
}

// Rounds before have opened the point by so much that half is lost: 1125 g = 80. Of the sound point 80 N take less, as
// above, so that is where it is in the end, with the damage of the start of the step.
TEUCHOS_UNIT_TEST(StrengthThatFalls, GivesBackWhatTheWayTook) {
  for (const bool held : {false, true}) {
    const auto s = solve({}, half, held ? held_first() : MethodParameters());
    TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(s.opening, 30.0 / 875, 1e-8);
    TEST_FLOATING_EQUALITY(s.pull, 50 - 125 * 30.0 / 875, 1e-8);
    expect_damage(s.damage, {}, out, success);
    TEST_EQUALITY(s.report.lost_on_the_way, 0);
  }
}

// Without solves to give it back the state of the way stays, 1125 g = 40, and its damage: half, of which the opening
// there would have taken 2.5 g.
TEUCHOS_UNIT_TEST(StrengthThatFalls, KeepsAndTellsWhatItCannotGiveBack) {
  MethodParameters methods;
  methods.active_set.patience = 0;
  const auto s = solve({40}, half, methods);
  TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
  TEST_FLOATING_EQUALITY(s.opening, 40.0 / 1125, 1e-8);
  TEST_FLOATING_EQUALITY(s.pull, 125 * 40.0 / 1125, 1e-7);
  expect_damage(s.damage, half, out, success);
  TEST_FLOATING_EQUALITY(s.report.lost_on_the_way, 0.5 - 2.5 * 40 / 1125, 1e-7);
}

// 60 N overload a brittle point by 10 N while strength is held: it breaks off, and stays so.
TEUCHOS_UNIT_TEST(StrengthThatFalls, LeavesBrokenOffWhatWasOverloadedWithHeldStrength) {
  const Mortar brittle{60, 0, {5, 2, false, true, true}};
  const auto s = solve(brittle, {}, held_first());
  TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
  TEST_FLOATING_EQUALITY(s.opening, 0.06, 1e-8);
  TEST_COMPARE(std::abs(s.pull), <=, 1e-7);
  expect_damage(s.damage, {0.4, 0.4, 0}, out, success);
  TEST_EQUALITY(s.report.lost_on_the_way, 0);
}

}  // namespace
