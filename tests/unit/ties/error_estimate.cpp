// What ties cost: violations against the law by hand, the error against the solution without ties.
#include "ties/error_estimate.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>

#include "support/tied_wall.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

// All points bear 10 N; those of block 2 on 0 are sheared with 8 N, 2 more than their friction of 0.6 allows.
TEUCHOS_UNIT_TEST(TiedViolations, AreDistancesFromTheLaw) {
  Experiment wall(tied_wall());
  const auto& model = wall.model();
  auto& state = wall.state();
  constexpr double mu = 0.6;  // of the scene
  const auto sheared = [&](int k) { return joint_of(model, k).block_i == 0 && joint_of(model, k).block_j == 2; };
  for (int k = 0; k < model.points().size(); ++k) {
    state.lambda[2 * k] = 10;
    state.lambda[2 * k + 1] = sheared(k) ? 10 * mu + 2 : -10 * mu;
  }
  const auto tied = tied_violations(model, model.law(), state, clusters(model, state.selected));
  TEST_EQUALITY(tied.largest_normal, 10.0);
  TEST_FLOATING_EQUALITY(tied.largest, 0.2, 1e-14);
  for (int k = 0; k < model.points().owned(); ++k) TEST_COMPARE(std::abs(tied.force[k] - 2 * sheared(k)), <=, 1e-13);
  // Energy that a spring of 4 N/m sets free.
  const auto decrease = predicted_decrease(tied, std::vector<double>(tied.force.size(), 4.0));
  for (int k = 0; k < model.points().owned(); ++k) TEST_COMPARE(std::abs(decrease[k] - 0.5 * sheared(k)), <=, 1e-13);
  // Points that are free violate nothing: the solver sees to them.
  std::fill(state.selected.begin(), state.selected.end(), 1);
  TEST_EQUALITY(tied_violations(model, model.law(), state, clusters(model, state.selected)).largest, 0.0);
}

TEUCHOS_UNIT_TEST(TiedViolations, DecreasesAreSummedOverRanksAndHeldToTheLargest) {
  const auto comm = Tpetra::getDefaultComm();
  const double ranks = comm->getSize();
  TEST_FLOATING_EQUALITY(root_of_decreases({3, 1}, 64 * ranks, 9, *comm), 0.25, 1e-15);
  TEST_EQUALITY(root_of_decreases({3, 1}, 2 * ranks, 9, *comm), 9.0);
  TEST_EQUALITY(root_of_decreases({}, 0, 9, *comm), 0.0);
}

// The joint between the half stones is drawn open. The estimate is the first Newton step towards the solution, so what
// it misses is of second order: points whose status that step changes.
TEUCHOS_UNIT_TEST(TieError, IsTheDistanceToTheSolutionWithoutTies) {
  Scene scene = tied_wall();
  scene.loads.resize(1);  // own weight
  add_pressure(scene, "right", -400);
  apply_all_loads(scene);
  Experiment tied(scene);
  TEST_ASSERT(tied.run());
  const auto& model = tied.model();
  const auto cluster = clusters(model, tied.state().selected);
  const auto violations = tied_violations(model, model.law(), tied.state(), cluster);
  TEST_COMPARE(violations.largest, >, 0);
  LinearSolver solver(scene.solver);
  const auto error =
      tie_error(parts_of(model, solver), {model.law(), tied.state().slip_origin, tied.load(), tied.prescribed()},
                tied.state(), cluster, violations);
  TEST_ASSERT(error.known);
  TEST_EQUALITY(error.linear_solves, 1);

  scene.selection.mode = SelectionMode::all;
  Experiment free(scene);
  TEST_ASSERT(free.run());
  const auto& s = model.structure();
  auto off = free.state().displacement, apart = off;
  for (std::size_t i = 0; i < off.size(); ++i) {
    apart[i] -= tied.state().displacement[i];
    off[i] = apart[i] - error.change[i];
  }
  out << "energy of the error " << s.elastic_energy(apart) << " J, of what the estimate misses "
      << s.elastic_energy(off) << " J\n";
  TEST_COMPARE(s.elastic_energy(apart), >, 0);
  TEST_COMPARE(s.elastic_energy(off), <=, 0.05 * s.elastic_energy(apart));
  const double truth = std::sqrt(s.elastic_energy(apart) / s.elastic_energy(free.state().displacement));
  TEST_FLOATING_EQUALITY(relative_error(s, tied.state().displacement, error, 0, 10), truth, 0.1);
  TEST_EQUALITY(relative_error(s, tied.state().displacement, error, 0, truth / 2), truth / 2);
}

TEUCHOS_UNIT_TEST(TieError, CostsNothingWhereTiesHold) {
  Scene scene = tied_wall();
  Experiment tied(scene);
  const auto& model = tied.model();
  LinearSolver solver(scene.solver);
  const auto cluster = clusters(model, tied.state().selected);
  const auto none = tied_violations(model, model.law(), tied.state(), cluster);
  const auto error =
      tie_error(parts_of(model, solver), {model.law(), tied.state().slip_origin, tied.load(), tied.prescribed()},
                tied.state(), cluster, none);
  TEST_EQUALITY(error.linear_solves, 0);
  TEST_EQUALITY(relative_error(model.structure(), tied.state().displacement, error, 0, 10), 0.0);
}

}  // namespace
