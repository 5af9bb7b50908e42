// The slider's shares are known by heart: friction of 0.3 bears 30 N, the spring the rest.
#include "nonlinear/patch.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "nonlinear/contact_solver.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

TEUCHOS_UNIT_TEST(Patch, SlidesUntilTheSpringBearsWhatFrictionCannot) {
  Patch patch = slider_on_the_ground(0.3);
  NewtonReport report;
  TEST_ASSERT(patch.solve(1e-9, report));
  TEST_FLOATING_EQUALITY(patch.displacement()[0], (push - 0.3 * weight) / spring, 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_points()[0].force[0], weight, 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_points()[0].force[1], 0.3 * weight, 1e-6);
  TEST_COMPARE(report.newton_iterations, >, 0);
}

TEUCHOS_UNIT_TEST(Patch, SticksWhereFrictionSuffices) {
  Patch patch = slider_on_the_ground(0.6);
  NewtonReport report;
  TEST_ASSERT(patch.solve(1e-9, report));
  TEST_COMPARE(std::abs(patch.displacement()[0]), <, 1e-9);
  TEST_FLOATING_EQUALITY(patch.solved_points()[0].force[1], push, 1e-6);
}

// Friction of 30 N lets it go, no spring holds it, and a neighbour is 1 cm away: five thousand times as far as damping
// lets it go in the first solve.
TEUCHOS_UNIT_TEST(Patch, GoesAsFarAsItsNeighbourWhereNothingHoldsIt) {
  auto parts = parts_of_slider(0.3);
  const double excess = 1e-3, way = 1e-2;
  parts.imbalance[0] = -(0.3 * weight + excess);
  parts.stiffness[0].value = 1e-6;
  auto neighbour = on_the_ground(0.0);
  neighbour.axis = {{{-1, 0}, {0, -1}}};
  neighbour.gap[0] = way;
  parts.points.push_back(neighbour);
  MethodParameters active_sets_alone;
  active_sets_alone.path.used = false;
  Patch patch(parts, active_sets_alone);
  NewtonReport report;
  const bool is_at_rest = patch.solve(1e-9, report);
  TEST_ASSERT(is_at_rest);
  if (!is_at_rest) return;  // there are no points to be looked at
  TEST_FLOATING_EQUALITY(patch.displacement()[0], way, 1e-4);
  TEST_FLOATING_EQUALITY(patch.solved_points()[0].force[1], 0.3 * weight, 1e-8);
  TEST_FLOATING_EQUALITY(patch.solved_points()[1].force[0], excess, 1e-4);
  TEST_COMPARE(report.newton_iterations, <=, 12);
}

/// The slider in space, on springs along x and y, pushed in a direction that is neither.
PatchParts parts_in_space(double friction, double angle) {
  PatchParts parts;
  parts.components = 3;
  parts.imbalance = {-push * std::cos(angle), -push * std::sin(angle), weight};
  parts.start = {0, 0, 0};
  parts.proximal_weight = {1e-6, 1e-6, 1e-6};
  parts.stiffness = {{0, 0, spring}, {1, 1, spring}, {2, 2, 1e-6}};
  parts.force_scale = weight;
  parts.length_scale = 1;
  PatchPoint p;
  p.shares = {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 1.0}};
  p.axis = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  p.law.friction = friction;
  p.local_stiffness = stone;
  parts.points = {p};
  return parts;
}

TEUCHOS_UNIT_TEST(Patch, SlidesInAnyDirectionOfSpace) {
  for (const double angle : {0.0, 0.7, 2.4}) {
    Patch patch(parts_in_space(0.3, angle));
    NewtonReport report;
    TEST_ASSERT(patch.solve(1e-9, report));
    const double way = (push - 0.3 * weight) / spring;
    const auto& force = patch.solved_points()[0].force;
    TEST_COMPARE(
        std::hypot(patch.displacement()[0] - way * std::cos(angle), patch.displacement()[1] - way * std::sin(angle)), <,
        1e-6 * way);
    TEST_FLOATING_EQUALITY(force[0], weight, 1e-6);
    TEST_COMPARE(std::hypot(force[1] + 0.3 * weight * std::cos(angle), force[2] + 0.3 * weight * std::sin(angle)), <,
                 1e-4 * weight);
  }
}

TEUCHOS_UNIT_TEST(Patch, BorderOfSpaceBearsAlongAllItsAxes) {
  auto parts = parts_in_space(0.3, 0.0);
  auto border = parts.points[0];
  parts.points.clear();
  border.resistance = {2 * spring, 3 * spring};
  border.resistance.tangential[2] = 4 * spring;
  parts.border = {border};
  parts.imbalance = {-push, -push, -push};
  parts.stiffness = {{0, 0, spring}, {1, 1, spring}, {2, 2, spring}};
  Patch patch(parts);
  NewtonReport report;
  TEST_ASSERT(patch.solve(1e-9, report));
  const double shares[] = {4, 5, 3};  // of the springs and the border together
  for (int c = 0; c < 3; ++c) TEST_FLOATING_EQUALITY(patch.displacement()[c], push / (shares[c] * spring), 1e-6);
  TEST_FLOATING_EQUALITY(patch.passed_on(), push * 4 / 5, 1e-6);
}

// A second unknown that nothing holds, not even a proximal term: no way of the patch has a regular system, and both end
// with the first.
TEUCHOS_UNIT_TEST(Patch, GivesUpWhereItsMatrixIsSingularAndSaysSo) {
  auto parts = parts_of_slider(0.3);
  parts.imbalance.push_back(1);
  parts.start.push_back(0);
  parts.proximal_weight.push_back(0);
  Patch patch(parts);
  NewtonReport report;
  TEST_ASSERT(!patch.solve(1e-9, report));
  TEST_EQUALITY(report.newton_iterations, 2);
  TEST_EQUALITY(report.failed_solves, 2);
  TEST_EQUALITY(report.failure, "UMFPACK found the matrix of a patch singular");
}

// Where neither active sets nor the path nor what closes has a regular system the solve ends with its reason.
TEUCHOS_UNIT_TEST(Patch, ASolveWithoutARegularSystemNamesTheLibrary) {
  auto parts = parts_of_slider(0.3);
  parts.imbalance.push_back(1);
  parts.start.push_back(0);
  parts.proximal_weight.push_back(0);
  Patch patch(parts);
  TpetraVector x(patch.map());
  PointField lambda = {weight, 0};
  FastWay fast;
  Damage no_damage;
  const auto report = ContactSolver(patch, {}, {}, fast).solve({x, lambda, no_damage}, {1e-9});
  TEST_ASSERT(report.outcome == NewtonOutcome::not_converged);
  TEST_COMPARE(report.newton_iterations, <=, 4);
  TEST_EQUALITY(report.failed_solves, report.newton_iterations);
  TEST_INEQUALITY(report.reason.find("UMFPACK found the matrix of a patch singular"), std::string::npos);
}

// Two nodes, one upon the other; below the lower one the border resists as a spring, whatever friction would say.
TEUCHOS_UNIT_TEST(Patch, KeepsTheStatusesOfItsBorder) {
  PatchParts parts;
  parts.components = 2;
  parts.imbalance = {-push, weight, 0, weight};
  parts.start.assign(4, 0.0);
  parts.proximal_weight.assign(4, 1e-6);
  parts.stiffness = {{0, 0, spring}, {1, 1, 1e-6}, {2, 2, spring}, {3, 3, 1e-6}};
  parts.force_scale = weight;
  parts.length_scale = 1;
  auto between = on_the_ground(0.3);
  between.shares = {{2, 0, -1.0}, {3, 1, -1.0}, {0, 0, 1.0}, {1, 1, 1.0}};
  parts.points = {between};
  auto below = on_the_ground(0.0);
  below.shares = {{2, 0, 1.0}, {3, 1, 1.0}};
  below.resistance = {stone, 2 * spring, 0};
  parts.border = {below};
  Patch patch(parts);
  NewtonReport report;
  TEST_ASSERT(patch.solve(1e-9, report));
  // 30 N arrive at the lower node, which its spring and the border share.
  TEST_FLOATING_EQUALITY(patch.displacement()[2], 30 / (3 * spring), 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_border()[0].force[1], 20.0, 1e-6);
  TEST_FLOATING_EQUALITY(patch.solved_border()[0].force[0], 2 * weight, 1e-6);
  TEST_FLOATING_EQUALITY(patch.passed_on(), 2 * weight, 1e-6);
}

}  // namespace
