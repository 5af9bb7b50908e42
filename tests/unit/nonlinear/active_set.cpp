// What active sets do with a solve that makes things worse, a slider that flies, of whose push friction bears 30 N; and
// with forces that creep from one point to another; and that mortar which loses strength as it opens and slips is
// solved as fast as Newton's method is.
#include "nonlinear/active_set.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "linalg/local_view.hpp"
#include "unit/nonlinear/softening_slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.3, at_rest = (push - friction * weight) / spring;  // [m]

/// Flies by a metre with every solve, less far where damping helps.
class Flying : public Patch {
 public:
  explicit Flying(bool helps) : Patch(parts_of_slider(friction)), helps_(helps) {}
  LinearSolveResult solve(const std::vector<PointStiffness>& resistance, double, const Teuchos::RCP<TpetraVector>&,
                          const Teuchos::RCP<TpetraVector>& d, const SolveRequest&) override {
    const double damping = resistance[0].along(0, 0) / stone;
    largest_damping = std::max(largest_damping, damping);
    d->putScalar(0);
    local_view_to_write(*d)[0] = helps_ && damping > 0 ? 1e-3 / damping : 1;
    return {1, true, "", false};
  }
  double largest_damping = 0;  ///< relative to the local stiffness

 private:
  bool helps_;
};

double damping_of(bool helps, const MethodParameters& methods = {}) {
  Flying problem(helps);
  TpetraVector x(problem.map());
  local_view_to_write(x)[0] = at_rest - 1e-3;  // a newton from rest
  PointField lambda = {weight, friction * weight};
  NewtonReport report;
  ActiveSet active(problem, ActiveSetUse::at_rest, methods, methods.active_set.patience);
  active.solve(x, lambda, 1e-9, 30, nullptr, report);
  return problem.largest_damping;
}

TEUCHOS_UNIT_TEST(ActiveSet, DampsStonesThatFlyAsLongAsThatHelps) { TEST_COMPARE(damping_of(true), >=, 0.1); }

TEUCHOS_UNIT_TEST(ActiveSet, DampsNoMoreWhereThatDoesNotHelp) {
  const double damping = damping_of(false);
  TEST_COMPARE(damping, >, 0);
  TEST_COMPARE(damping, <=, 0.01 * (1 + 1e-12));
}

TEUCHOS_UNIT_TEST(ActiveSet, DampsNothingWhereThatIsSwitchedOff) {
  MethodParameters methods;
  methods.active_set.damping = 0;
  TEST_EQUALITY(damping_of(true, methods), 0.0);
}

// The node of the slider stands on two points, one so little below the other that a solve moves 0.1 N from one to the
// other, or 1e-5 N. In the end it bears everything, which takes no more solves for that.
TEUCHOS_UNIT_TEST(ActiveSet, SendsForcesThatCreepToWhereAPointOpens) {
  for (const auto use : {ActiveSetUse::at_rest, ActiveSetUse::in_time})
    for (const double step : {2e-9, 2e-13}) {
      auto parts = parts_of_slider(friction);
      parts.imbalance[0] = 0;
      parts.points = {on_the_ground(friction), on_the_ground(friction)};
      parts.points[0].gap[0] = step;
      Patch problem(parts);
      TpetraVector x(problem.map());
      PointField lambda = {weight / 2, 0, weight / 2, 0};
      NewtonReport report;
      ActiveSet active(problem, use, MethodParameters(), ActiveSetParameters().patience);
      TEST_ASSERT(active.solve(x, lambda, 1e-11, 30, nullptr, report) == ActiveSetEnd::arrived);
      TEST_EQUALITY(lambda[0], 0);
      TEST_FLOATING_EQUALITY(lambda[2], weight, 1e-6);
      TEST_COMPARE(report.newton_iterations, <=, 8);
    }
}

// Two points share the node of the slider, which slides: what one loses of its pressure takes its friction along.
TEUCHOS_UNIT_TEST(ActiveSet, SendsForcesThatCreepWhereStonesSlide) {
  auto parts = parts_of_slider(friction);
  parts.points = {on_the_ground(friction), on_the_ground(friction)};
  parts.points[0].gap[0] = 2e-13;
  Patch problem(parts);
  TpetraVector x(problem.map());
  PointField lambda = {weight / 2, friction * weight / 2, weight / 2, friction * weight / 2};
  NewtonReport report;
  ActiveSet active(problem, ActiveSetUse::in_time, MethodParameters(), ActiveSetParameters().patience);
  TEST_ASSERT(active.solve(x, lambda, 1e-11, 30, nullptr, report) == ActiveSetEnd::arrived);
  TEST_EQUALITY(lambda[0], 0);
  TEST_FLOATING_EQUALITY(local_view(x)[0], at_rest, 1e-6);
  TEST_COMPARE(report.newton_iterations, <=, 12);
}

// Pulled off obliquely; a rate a quarter as steep as the springs.
TEUCHOS_UNIT_TEST(ActiveSet, FollowsStrengthThatFallsAsFastAsNewtonsMethod) {
  for (const bool exponential : {false, true})
    for (const bool springs : {false, true}) {
      const Mortar mortar{80, 90, {5, 2, exponential}, springs ? 1e-4 : 0};
      Mortared problem(mortar);
      const Damage sound(1);
      TpetraVector x(problem.map());
      PointField lambda(2, 0.0);
      NewtonReport report;
      ActiveSet active(problem, ActiveSetUse::at_rest, {}, ActiveSetParameters().patience, fall(sound));
      TEST_ASSERT(active.solve(x, lambda, 1e-12, 30, nullptr, report) == ActiveSetEnd::arrived);
      TEST_COMPARE(report.newton_iterations, <=, exponential ? 6 : 5);
      const double c = mortar.compliance;
      const double opened = local_view(x)[1] + c * lambda[0], slipped = std::abs(local_view(x)[0] - c * lambda[1]);
      const double kappa = std::hypot(5 * opened, 2 * slipped), left = exponential ? std::exp(-kappa) : 1 - kappa / 2;
      TEST_FLOATING_EQUALITY(lambda[0], -left * Mortared::strength, 1e-9);
      TEST_FLOATING_EQUALITY(std::abs(lambda[1]), left * (Mortared::cohesion - 0.6 * Mortared::strength), 1e-9);
      TEST_FLOATING_EQUALITY(spring * local_view(x)[1], mortar.up + lambda[0], 1e-9);
    }
}

}  // namespace
