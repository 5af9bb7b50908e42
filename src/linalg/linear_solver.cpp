#include "linalg/linear_solver.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <utility>

#include "base/check.hpp"

namespace voussoir {
namespace {

/// A Preconditioner seen as the operator Belos expects.
class PreconditionerOperator : public TpetraOperator {
 public:
  PreconditionerOperator(std::shared_ptr<const Preconditioner> m, Teuchos::RCP<const TpetraMap> map)
      : m_(std::move(m)), map_(std::move(map)) {}
  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return map_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return map_; }
  void apply(const TpetraMultiVector& x, TpetraMultiVector& y, Teuchos::ETransp,
             [[maybe_unused]] double alpha, [[maybe_unused]] double beta) const override {
    VOUSSOIR_EXPECT(alpha == 1.0 && beta == 0.0);
    for (std::size_t j = 0; j < x.getNumVectors(); ++j) m_->apply(*x.getVector(j), *y.getVectorNonConst(j));
  }

 private:
  std::shared_ptr<const Preconditioner> m_;
  Teuchos::RCP<const TpetraMap> map_;
};

}  // namespace

struct LinearSolver::Data {
  using Problem = Belos::LinearProblem<double, TpetraMultiVector, TpetraOperator>;
  SolverParameters parameters;
  Teuchos::RCP<Belos::SolverManager<double, TpetraMultiVector, TpetraOperator>> manager;
};

LinearSolver::LinearSolver(const SolverParameters& parameters) : data_(std::make_unique<Data>()) {
  data_->parameters = parameters;
}

LinearSolver::~LinearSolver() = default;

LinearSolveResult LinearSolver::solve(const Teuchos::RCP<const TpetraOperator>& a,
                                      const std::shared_ptr<const Preconditioner>& m,
                                      const Teuchos::RCP<const TpetraVector>& b, const Teuchos::RCP<TpetraVector>& x,
                                      double relative_tolerance) {
  auto problem = Teuchos::rcp(new Data::Problem(a, x, b));
  const auto& given = data_->parameters;
  if (m) {
    const auto preconditioner = Teuchos::rcp(new PreconditionerOperator(m, b->getMap()));
    // On the right GMRES sees the residual itself; its flexible variant knows no other side.
    if (given.method == "FLEXIBLE GMRES") {
      problem->setRightPrec(preconditioner);
    } else {
      problem->setLeftPrec(preconditioner);
    }
  }
  problem->setHermitian();
  problem->setProblem();

  auto list = Teuchos::parameterList(given.belos);
  list->set("Convergence Tolerance", relative_tolerance);
  list->set("Maximum Iterations", given.largest_iterations);
  const double size = b->norm2();
  if (size == 0) {
    x->putScalar(0);
    return {0, true};
  }
  // Relative to the right-hand side, not to a first residual that a good start makes small.
  if (!list->isParameter("Implicit Residual Scaling")) list->set("Implicit Residual Scaling", "Norm of RHS");
  if (data_->manager.is_null()) {
    Belos::SolverFactory<double, TpetraMultiVector, TpetraOperator> factory;
    data_->manager = factory.create(given.method, list);
  } else {
    data_->manager->setParameters(list);
  }
  data_->manager->setProblem(problem);
  try {
    const bool converged = data_->manager->solve() == Belos::Converged;
    return {data_->manager->getNumIters(), converged};
  } catch (const std::exception&) {  // curvature lost to round-off; x holds what was reached
    return {data_->manager->getNumIters(), false};
  }
}

}  // namespace voussoir
