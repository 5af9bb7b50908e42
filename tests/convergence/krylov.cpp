// Conjugate gradients need as many iterations for a large structure as for a small one: counts, no seconds.
//
// The systems are those of a solution with all points selected: closed points resist in normal direction, sticking ones
// in tangential direction, and what is open is free. Two right-hand sides, the loads and one without any pattern, to
// a relative residual of 1e-8; the larger count is compared. Systems are not factored whole, as the program does with
// those that take more than 20 iterations: what is counted is what the parts of the preconditioner are good for.
#include <Teuchos_UnitTestHarness.hpp>
#include <algorithm>
#include <cmath>

#include "support/scenes.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

/// Statuses are those of an adaptive run with 1 % error: points it left tied stick.
int iterations_at_solution(Scene scene) {
  scene.selection.mode = SelectionMode::adaptive;
  scene.selection.error_tolerance = 0.01;
  scene.preconditioner.factored_up_to = 0;
  Experiment experiment(scene);
  if (!experiment.run()) return -1;
  auto state = experiment.state();
  const auto& model = experiment.model();
  const double force = experiment.solution().largest_force();
  std::vector<PointStiffness> stiffness(model.points().size());
  for (int k = 0; k < model.points().size(); ++k) {
    const double normal = state.lambda[2 * k], tangential = std::abs(state.lambda[2 * k + 1]);
    const bool closed = !state.selected[k] || normal > 1e-7 * force;  // ten times what Newton leaves
    const bool sticks = !state.selected[k] || tangential < (1 - 1e-6) * model.law()[k].friction * normal;
    const double stone = model.local_stiffness()[k];
    if (closed) stiffness[k] = {stone, sticks ? stone : 0.0};
  }
  std::fill(state.selected.begin(), state.selected.end(), 1);

  LinearSolver solver(model.settings().solver);
  const ContactProblem::Parts parts{model.structure(),
                                    model.points(),
                                    model.continuum(),
                                    model.held(),
                                    model.local_stiffness(),
                                    {},
                                    model.settings().preconditioner,
                                    model.settings().internals,
                                    solver};
  ContactProblem problem(parts, state.selected,
                         {model.law(), state.slip_origin, experiment.load(), experiment.prescribed()});
  auto patternless = experiment.load();
  for (std::size_t i = 0; i < patternless.size(); ++i) patternless[i] = std::sin(1 + 1.7 * static_cast<double>(i));
  int most = 0;
  for (const auto& nodal : {experiment.load(), patternless}) {
    const auto b = Teuchos::rcp(new TpetraVector(problem.map())), x = Teuchos::rcp(new TpetraVector(problem.map()));
    problem.space().sum(nodal, *b);
    const auto solve = [&] { return problem.solve(stiffness, 1.0, b, x, {1e-8, 0}).iterations; };
    x->putScalar(0);
    most = std::max(most, solve());
  }
  return most;
}

// Flat means a factor of 1.5 while the number of unknowns grows by 16 and 8. Measured: 16, 22, 24 for the walls and
// 17, 20, 21, 25 for the arches.
TEUCHOS_UNIT_TEST(Krylov, IterationsStayWhereTheyAreWhenAWallGrows) {
  const int small = iterations_at_solution(wall_scene(8)), middle = iterations_at_solution(wall_scene(16)),
            large = iterations_at_solution(wall_scene(32));
  out << "W(8), W(16), W(32): " << small << ", " << middle << ", " << large << "\n";
  TEST_COMPARE(small, >, 0);
  TEST_COMPARE(middle, >, 0);
  TEST_COMPARE(large, >, 0);
  TEST_COMPARE(std::max(middle, large), <=, 1.5 * small);
  TEST_COMPARE(large, <=, 30);
}

TEUCHOS_UNIT_TEST(Krylov, IterationsStayWhereTheyAreWhenAnArchHasMoreVoussoirs) {
  std::vector<int> counts;
  for (int voussoirs : {15, 31, 61, 121}) {
    counts.push_back(iterations_at_solution(arch_scene(voussoirs)));
    out << "A(" << voussoirs << "): " << counts.back() << "\n";
    TEST_COMPARE(counts.back(), >, 0);
    TEST_COMPARE(counts.back(), <=, 1.5 * counts.front());
    TEST_COMPARE(counts.back(), <=, 30);
  }
}

// Measured: 16 and 26. Motions of stones as wholes do not see that partly open joints make a structure softer
// (src/homogenisation/README.md, Limits).
TEUCHOS_UNIT_TEST(LargeWall, Of64CoursesTakesLittleMoreThanASmallOne) {
  const int small = iterations_at_solution(wall_scene(8)), large = iterations_at_solution(wall_scene(64));
  out << "W(8), W(64): " << small << ", " << large << "\n";
  TEST_COMPARE(small, >, 0);
  TEST_COMPARE(large, >, 0);
  TEST_COMPARE(large, <=, 1.75 * small);
  TEST_COMPARE(large, <=, 30);
}

}  // namespace
