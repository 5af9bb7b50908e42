// Krylov solutions: judged by the residual b - A x itself, not by what the solver says of it.
#include "linalg/linear_solver.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <cmath>

#include "base/check.hpp"
#include "linalg/solver_failure.hpp"
#include "unit/linalg/systems.hpp"

namespace {

using namespace voussoir;
using namespace voussoir::test;

constexpr int side = 12;  // nodes; 288 unknowns, some 40 iterations without preconditioner

/// Divides by a positive number that varies over six orders with the row.
class Scaling final : public Preconditioner {
 public:
  explicit Scaling(double sign) : sign_(sign) {}
  void apply(const TpetraVector& r, TpetraVector& z) const override {
    for (std::size_t i = 0; i < r.getLocalLength(); ++i) {
      const auto row = r.getMap()->getGlobalElement(static_cast<int>(i));
      local_view_to_write(z)[i] = (row % 2 ? sign_ : 1.0) * scale(row) * local_view(r)[i];
    }
  }
  static double scale(long long row) { return std::pow(10.0, 3 * noise(row)); }

 private:
  double sign_;
};

/// The coupled Laplacian with rows and columns multiplied by 1 / sqrt(scale), which the Scaling undoes.
Rows badly_scaled() {
  return [](long long row) {
    auto entries = coupled_laplacian(side)(row);
    for (auto& [column, value] : entries) value /= std::sqrt(Scaling::scale(row) * Scaling::scale(column));
    return entries;
  };
}

TEUCHOS_UNIT_TEST(LinearSolver, TheResidualIsSmallerThanTheWantedShareOfTheRightHandSide) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
    auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
    const auto result = solver.solve(a, nullptr, b, x, tolerance);
    TEST_ASSERT(result.converged);
    // The residual of the recursion drifts from the true one by round-off times the condition (100): 1e-14.
    TEST_COMPARE(relative_residual(*a, *b, *x), <=, 1.001 * tolerance);
    // Not solved more tightly than asked: one iteration gains far less than a factor of 100 here.
    TEST_COMPARE(relative_residual(*a, *b, *x), >=, 0.01 * tolerance);
  }
}

TEUCHOS_UNIT_TEST(LinearSolver, APreconditionerSavesIterationsAndLeavesTheMeaningOfTheTolerance) {
  const auto a = distributed(2 * side * side, badly_scaled(), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  auto plain = Teuchos::rcp(new TpetraVector(a->getRowMap())), x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
  const auto without = solver.solve(a, nullptr, b, plain, 1e-8);
  const auto with = solver.solve(a, std::make_shared<Scaling>(1.0), b, x, 1e-8);
  TEST_ASSERT(with.converged);
  TEST_COMPARE(2 * with.iterations, <, without.iterations);
  // The rows differ by six orders: a tolerance measured after preconditioning would miss this by up to three.
  TEST_COMPARE(relative_residual(*a, *b, *x), <=, 1.001e-8);
}

TEUCHOS_UNIT_TEST(LinearSolver, AGoodStartIsUsedAndNotHeldToATighterTolerance) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
  TEST_ASSERT(solver.solve(a, nullptr, b, x, 1e-6).converged);
  // Relative to the residual of the start it would take as many iterations again.
  TEST_COMPARE(solver.solve(a, nullptr, b, x, 1e-5).iterations, <=, 1);
}

TEUCHOS_UNIT_TEST(LinearSolver, AZeroRightHandSideHasTheZeroSolution) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = Teuchos::rcp(new TpetraVector(a->getRowMap()));
  LinearSolver solver({});
  const auto x = noise_vector(a->getRowMap());
  const auto result = solver.solve(a, nullptr, b, x, 1e-10);
  TEST_ASSERT(result.converged);
  TEST_EQUALITY(result.iterations, 0);
  TEST_EQUALITY(x->normInf(), 0.0);
}

TEUCHOS_UNIT_TEST(LinearSolver, TooFewIterationsAreReported) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  SolverParameters parameters;
  parameters.largest_iterations = 3;
  LinearSolver solver(parameters);
  const auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
  const auto result = solver.solve(a, nullptr, b, x, 1e-10);
  TEST_ASSERT(!result.converged);
  TEST_ASSERT(!result.nothing);  // what was reached is there
  TEST_COMPARE(x->norm2(), >, 0);
  TEST_EQUALITY(result.iterations, 3);
  TEST_EQUALITY(result.failure, "CG did not reach 1e-10 in 3 iterations");
}

/// As where MUMPS loses its factors.
class Refusing final : public Preconditioner {
 public:
  void apply(const TpetraVector&, TpetraVector&) const override { throw solver_failure("LIBRARY", "solve", -7); }
};

TEUCHOS_UNIT_TEST(LinearSolver, WhatThePreconditionerFailsAtIsNamed) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::none}) {
    const auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
    const auto result = solver.solve(a, std::make_shared<Refusing>(), b, x, 1e-10, symmetry);
    TEST_ASSERT(!result.converged);
    TEST_ASSERT(result.nothing);  // so that nobody asks for the same again
    TEST_EQUALITY(result.failure, (symmetry == Symmetry::symmetric ? "CG" : "FLEXIBLE GMRES") +
                                      std::string(" stopped: LIBRARY could not solve (its status: -7)"));
  }
}

/// As where the blocks of the last rank cannot be solved in the second iteration.
class FailingOnTheLastRank final : public Preconditioner {
 public:
  void apply(const TpetraVector& r, TpetraVector& z) const override {
    const auto comm = r.getMap()->getComm();
    const bool fails = ++applied_ == 2 && comm->getRank() == comm->getSize() - 1;
    std::vector<double> part(local_view(r), local_view(r) + r.getLocalLength());
    solve_or_not_a_number(part, [&] {
      if (fails) throw solver_failure("LIBRARY", "solve", -7);
    });
    largest_over_ranks(*comm, 0);  // what follows it in a preconditioner may be collective
    std::copy(part.begin(), part.end(), local_view_to_write(z));
  }

 private:
  mutable int applied_ = 0;
};

TEUCHOS_UNIT_TEST(LinearSolver, WhatFailsOnOneRankEndsTheIterationOfAllAndLeavesNumbers) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::none}) {
    const auto x = noise_vector(a->getRowMap());
    const TpetraVector start(*x, Teuchos::Copy);
    const auto result = solver.solve(a, std::make_shared<FailingOnTheLastRank>(), b, x, 1e-10, symmetry);
    out << result.failure << "\n";
    TEST_ASSERT(!result.converged && !result.failure.empty());
    // What was reached before, or what was there.
    TEST_ASSERT(std::isfinite(x->norm2()));
    x->update(-1.0, start, 1.0);
    TEST_ASSERT(!result.nothing || x->norm2() == 0);
    // The next system is solved.
    TEST_ASSERT(solver.solve(a, nullptr, b, x, 1e-6, symmetry).converged);
  }
}

class BreakingAContract final : public Preconditioner {
 public:
  void apply(const TpetraVector& r, TpetraVector& z) const override { VOUSSOIR_EXPECT(&r == &z); }
};

// What is a mistake of the program is no failure of a method. Here on all ranks, so that none is left waiting.
TEUCHOS_UNIT_TEST(LinearSolver, ABrokenContractIsNoSolveThatStopped) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::none}) {
    const auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
    TEST_THROW(solver.solve(a, std::make_shared<BreakingAContract>(), b, x, 1e-10, symmetry), std::logic_error);
  }
}

TEUCHOS_UNIT_TEST(LinearSolver, AnIndefinitePreconditionerIsReportedAndNotThrown) {
  const auto a = distributed(2 * side * side, coupled_laplacian(side), everyone());
  const auto b = noise_vector(a->getRowMap());
  LinearSolver solver({});
  auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
  LinearSolveResult result{0, true, "", false};
  TEST_NOTHROW(result = solver.solve(a, std::make_shared<Scaling>(-1.0), b, x, 1e-10));
  TEST_ASSERT(!result.converged);
  // And the solver serves the next system.
  x->putScalar(0);
  TEST_ASSERT(solver.solve(a, nullptr, b, x, 1e-10).converged);
}

TEUCHOS_UNIT_TEST(LinearSolver, EveryMethodASceneCanNameSolvesAPreconditionedSystem) {
  const auto a = distributed(2 * side * side, badly_scaled(), everyone());
  const auto b = noise_vector(a->getRowMap());
  for (const char* method : {"CG", "PSEUDOBLOCK CG", "FLEXIBLE GMRES"}) {
    out << method << "\n";
    SolverParameters parameters;
    parameters.method = method;
    LinearSolver solver(parameters);
    for (int time = 0; time < 2; ++time) {  // the second time the solver exists already
      auto x = Teuchos::rcp(new TpetraVector(a->getRowMap()));
      LinearSolveResult result;
      TEST_NOTHROW(result = solver.solve(a, std::make_shared<Scaling>(1.0), b, x, 1e-8));
      TEST_ASSERT(result.converged);
      TEST_COMPARE(relative_residual(*a, *b, *x), <=, 1.001e-8);
    }
  }
}

}  // namespace
