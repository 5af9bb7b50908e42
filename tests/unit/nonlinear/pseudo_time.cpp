// A slider that nothing holds falls without end, and is told so; one that friction or a spring holds comes to rest.
#include "nonlinear/pseudo_time.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "linalg/local_view.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

struct End {
  NewtonReport report;
  double place = 0, direction = 0;
  PointField lambda;
};

/// @param spring_share  of the spring that holds the slider
End let_go(double friction, double spring_share, double off = 0, const MethodParameters& methods = {}) {
  auto parts = parts_of_slider(friction);
  parts.stiffness[0].value *= spring_share;
  parts.proximal_weight = {1, 1};
  Patch problem(parts);
  TpetraVector x(problem.map());
  local_view_to_write(x)[1] = off;
  End end;
  end.lambda = {weight, 0};
  PseudoTime falling(problem, {}, methods);
  falling.integrate(x, end.lambda, 1e-9, nullptr, 200, end.report);
  end.place = local_view(x)[0];
  end.direction = local_view(falling.mechanism())[0];
  return end;
}

TEUCHOS_UNIT_TEST(PseudoTime, ComesToRestWhereASpringHolds) {
  for (const double off : {0.0, 1e-3, -1e-3}) {  // begun in the air, and in the ground
    const auto end = let_go(0.3, 1, off);
    TEST_ASSERT(end.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(end.place, (push - 0.3 * weight) / spring, 1e-6);
    TEST_FLOATING_EQUALITY(end.lambda[1], 0.3 * weight, 1e-6);
  }
}

TEUCHOS_UNIT_TEST(PseudoTime, ComesToRestWhereFrictionHolds) {
  const auto end = let_go(0.6, 0);
  TEST_ASSERT(end.report.outcome == NewtonOutcome::converged);
  TEST_FLOATING_EQUALITY(end.lambda[1], push, 1e-6);
}

TEUCHOS_UNIT_TEST(PseudoTime, TellsAFallAndWhereItGoes) {
  for (const double friction : {0.0, 0.3, 0.499}) {
    const auto end = let_go(friction, 0);
    TEST_ASSERT(end.report.outcome == NewtonOutcome::collapse);
    TEST_FLOATING_EQUALITY(end.direction, 1.0, 1e-9);
    TEST_COMPARE(end.report.newton_iterations, <=, 30);
  }
}

// With a tenth of the spring the slider goes 0.2 m, a fifth of the structure, and rests there: no fall, however far the
// first step goes. Whether a structure may move so far is asked of its whole state, not of a step.
TEUCHOS_UNIT_TEST(PseudoTime, WhatGoesFarAndRestsIsNoFall) {
  for (const double share : {0.1, 0.03}) {
    const auto end = let_go(0.3, share);
    TEST_ASSERT(end.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(end.place, (push - 0.3 * weight) / (share * spring), 1e-6);
  }
}

TEUCHOS_UNIT_TEST(PseudoTime, GivesUpWhereItsSolvesAreSpent) {
  auto parts = parts_of_slider(0.3);
  Patch problem(parts);
  TpetraVector x(problem.map());
  PointField lambda = {weight, 0};
  NewtonReport report;
  PseudoTime(problem, {}, MethodParameters()).integrate(x, lambda, 1e-15, nullptr, 1, report);
  TEST_ASSERT(report.outcome == NewtonOutcome::not_converged);
  TEST_EQUALITY(report.newton_iterations, 1);
  TEST_INEQUALITY(report.reason.find("largest number"), std::string::npos);
}

}  // namespace
