// Each way through the contact conditions finds the slider's rest alone, and one that is switched off makes no solve.
#include "nonlinear/contact_solver.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include "linalg/local_view.hpp"
#include "unit/nonlinear/slider.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr double friction = 0.3, at_rest = (push - friction * weight) / spring;  // [m]

MethodParameters none() {
  MethodParameters methods;
  methods.solver.active_sets = methods.path.used = methods.pseudo_time.used = false;
  return methods;
}

struct Solved {
  NewtonReport report;
  double place = 0;    ///< [m]
  int fast_waits = 0;  ///< for active sets
};

Solved solve(const MethodParameters& methods) {
  Patch problem = slider_on_the_ground(friction);
  TpetraVector x(problem.map());
  PointField lambda = {weight, 0};
  Damage no_damage;
  FastWay fast;
  Solved s;
  s.report = ContactSolver(problem, {}, methods, fast).solve({x, lambda, no_damage}, {1e-9});
  s.place = local_view(x)[0];
  s.fast_waits = fast.next_wait;
  return s;
}

TEUCHOS_UNIT_TEST(ContactSolver, MakesNoSolveWhereEveryWayIsSwitchedOff) {
  const auto s = solve(none());
  TEST_ASSERT(s.report.outcome == NewtonOutcome::not_converged);
  TEST_EQUALITY(s.report.newton_iterations, 0);
  TEST_EQUALITY(s.place, 0.0);
  TEST_INEQUALITY(s.report.reason.find("switched off"), std::string::npos);
}

TEUCHOS_UNIT_TEST(ContactSolver, FindsRestByEachWayAlone) {
  for (const int way : {0, 1, 2}) {
    auto methods = none();
    (way == 0 ? methods.solver.active_sets : way == 1 ? methods.path.used : methods.pseudo_time.used) = true;
    const auto s = solve(methods);
    out << "way " << way << ": " << s.report.newton_iterations << " solves\n";
    TEST_ASSERT(s.report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(s.place, at_rest, 1e-6);
  }
}

// Whoever is asked after a linear solve ends the whole of it there, whichever way it is on.
TEUCHOS_UNIT_TEST(ContactSolver, EndsAtTheSolveAfterWhichNoMoreAreWanted) {
  for (const int way : {0, 1, 2, 3, 4}) {
    auto methods = way < 3 ? none() : MethodParameters{};
    if (way == 0) methods.solver.active_sets = true;
    if (way == 1) methods.path.used = true;
    if (way == 2) methods.pseudo_time.used = true;
    if (way == 3) methods.solver.fast_solves = 1;  // active sets fail, and the path offers them its end
    auto parts = parts_of_slider(friction);
    if (way == 4) parts.points.clear(), parts.imbalance[1] = 0;  // a linear system
    const auto stopped_after = [&](int most) {
      Patch problem(parts);
      TpetraVector x(problem.map());
      PointField lambda = way == 4 ? PointField{} : PointField{weight, 0};
      Damage no_damage;
      FastWay fast;
      ContactSolver solver(problem, {}, methods, fast);
      int asked = 0;
      solver.watch = [&](const NewtonProgress&) { return ++asked < most ? GoOn::yes : GoOn::no; };
      const auto report = solver.solve({x, lambda, no_damage}, {1e-9});
      TEST_COMPARE(asked, <=, most);
      return report;
    };
    const auto whole = stopped_after(1000);
    TEST_ASSERT(whole.outcome == NewtonOutcome::converged);
    for (int most = 1; most <= whole.newton_iterations; ++most) {
      const auto report = stopped_after(most);
      TEST_ASSERT(report.outcome == NewtonOutcome::stopped);
      TEST_EQUALITY(report.newton_iterations, most);
    }
  }
}

// One solve is not enough for active sets: they fail, and are left out of the next solve.
TEUCHOS_UNIT_TEST(ContactSolver, BacksOffOnlyWhereThatIsSwitchedOn) {
  for (const bool back_off : {true, false}) {
    MethodParameters methods;
    methods.solver.fast_solves = 1;
    methods.solver.back_off = back_off;
    TEST_EQUALITY(solve(methods).fast_waits, back_off ? 1 : 0);
  }
}

// Without contact points the system is linear: a spring holds the node after one solve; without it nothing does.
TEUCHOS_UNIT_TEST(ContactSolver, WithoutPointsASpringHoldsAndWhatNothingHoldsFalls) {
  for (const bool held : {true, false}) {
    auto parts = parts_of_slider(friction);
    parts.points.clear();
    parts.imbalance[1] = 0;
    if (!held) parts.stiffness[0].value = 0;
    Patch problem(parts);
    TpetraVector x(problem.map());
    PointField lambda;
    Damage no_damage;
    FastWay fast;
    ContactSolver solver(problem, {}, {}, fast);
    const auto report = solver.solve({x, lambda, no_damage}, {1e-9});
    TEST_ASSERT(report.outcome == (held ? NewtonOutcome::converged : NewtonOutcome::collapse));
    TEST_COMPARE(report.newton_iterations, <=, held ? 1 : 3);
    TEST_FLOATING_EQUALITY(held ? local_view(x)[0] * spring / push : local_view(solver.mechanism())[0], 1.0, 1e-9);
  }
}

/// The slider, of whose weight as much as is given is told to run round with other stones.
class SharedSlider : public Patch {
 public:
  explicit SharedSlider(double runs_round) : Patch(parts_of_slider(friction)), runs_round_(runs_round) {}
  bool shares_forces() const override { return true; }
  void split_shared_forces(const std::vector<PointFreedom>&, SharedFriction how, PointField& lambda) const override {
    if (how == SharedFriction::held_where_it_hides) lambda[0] -= runs_round_;
  }

 private:
  double runs_round_;  // [N]
};

// A split that no equilibrium keeps is not taken, and the report says by how much and where it differs.
TEUCHOS_UNIT_TEST(ContactSolver, TellsForcesThatCannotBeSplitInOneWay) {
  for (const double runs_round : {0.0, 5.0}) {
    SharedSlider problem(runs_round);
    TpetraVector x(problem.map());
    PointField lambda = {weight, 0};
    Damage no_damage;
    FastWay fast;
    const auto report = ContactSolver(problem, {}, {}, fast).solve({x, lambda, no_damage}, {1e-9});
    TEST_ASSERT(report.outcome == NewtonOutcome::converged);
    TEST_FLOATING_EQUALITY(lambda[0], weight, 1e-9);
    TEST_FLOATING_EQUALITY(local_view(x)[0], at_rest, 1e-6);
    TEST_COMPARE(std::abs(report.undetermined - runs_round / weight), <, 1e-9);
    TEST_EQUALITY(report.undetermined_at, runs_round > 0 ? 0 : -1);
  }
}

}  // namespace
