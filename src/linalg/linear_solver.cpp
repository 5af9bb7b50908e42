#include "linalg/linear_solver.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <BelosTypes.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "base/words.hpp"
#include "linalg/solver_failure.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {
namespace {

// Vectors after which GMRES begins anew; the flexible one keeps each with its preconditioned form. With 40 the deformed
// bridge takes three tenths more iterations, with 30 its time steps a third more.
constexpr int restart = 60;

/// Of what Teuchos throws: before come the place and the condition in the code.
std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of(" \n");
  if (end == std::string::npos) return text;
  const auto before = text.find_last_of('\n', end);
  const auto start = before == std::string::npos ? 0 : before + 1;
  return text.substr(start, end + 1 - start);
}

/// Whether an error is a mistake of this program: a broken contract, an index that is none. Such an error may be of one
/// rank alone, which must not go on while the others wait for it; it ends the program. Errors of the libraries are of
/// the same standard type, and named by types of their own.
bool is_our_mistake(const std::exception& error) {
  return dynamic_cast<const std::logic_error*>(&error) && !dynamic_cast<const Belos::BelosError*>(&error) &&
         !dynamic_cast<const Teuchos::ExceptionBase*>(&error);
}

bool differ_by_nothing(const TpetraVector& x, const TpetraVector& start) {
  TpetraVector way(x, Teuchos::Copy);
  way.update(-1.0, start, 1.0);
  return way.norm2() == 0;
}

/// A Preconditioner seen as the operator Belos expects.
class PreconditionerOperator : public TpetraOperator {
 public:
  PreconditionerOperator(std::shared_ptr<const Preconditioner> m, Teuchos::RCP<const TpetraMap> map)
      : m_(std::move(m)), map_(std::move(map)) {}
  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return map_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return map_; }
  void apply(const TpetraMultiVector& x, TpetraMultiVector& y, Teuchos::ETransp, [[maybe_unused]] double alpha,
             [[maybe_unused]] double beta) const override {
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
  using Manager = Belos::SolverManager<double, TpetraMultiVector, TpetraOperator>;
  Teuchos::RCP<Manager> manager[2];  ///< for symmetric systems and others
};

namespace {

/// What Belos is asked of one system.
Teuchos::RCP<Teuchos::ParameterList> asked_of_belos(const SolverParameters& given, bool symmetric,
                                                    double relative_tolerance, int largest_iterations) {
  auto list = Teuchos::parameterList(symmetric ? given.belos : given.belos_unsymmetric);
  list->set("Convergence Tolerance", relative_tolerance);
  const int most = largest_iterations > 0 ? largest_iterations : given.largest_iterations;
  list->set("Maximum Iterations", std::min(most, given.largest_iterations));
  const bool restarts = !symmetric && given.unsymmetric_method != "BICGSTAB";
  if (restarts && !list->isParameter("Num Blocks")) list->set("Num Blocks", restart);
  // Relative to the right-hand side, not to a first residual that a good start makes small.
  if (!list->isParameter("Implicit Residual Scaling")) list->set("Implicit Residual Scaling", "Norm of RHS");
  return list;
}

}  // namespace

LinearSolver::LinearSolver(const SolverParameters& parameters) : data_(std::make_unique<Data>()) {
  data_->parameters = parameters;
}

LinearSolver::~LinearSolver() = default;

LinearSolveResult LinearSolver::solve(const Teuchos::RCP<const TpetraOperator>& a,
                                      const std::shared_ptr<const Preconditioner>& m,
                                      const Teuchos::RCP<const TpetraVector>& b, const Teuchos::RCP<TpetraVector>& x,
                                      double relative_tolerance, Symmetry symmetry, int largest_iterations) {
  const TrafficScope sent_for(TrafficOf::krylov);
  if (b->norm2() == 0) {
    x->putScalar(0);
    return {0, true, "", false};
  }
  auto problem = Teuchos::rcp(new Data::Problem(a, x, b));
  const auto& given = data_->parameters;
  const bool symmetric = symmetry == Symmetry::symmetric;
  const auto& method = symmetric ? given.method : given.unsymmetric_method;
  auto& manager = data_->manager[symmetric ? 0 : 1];
  // Right preconditioning. GMRES then monitors the true residual, and its flexible variant, which supports this side
  // only, saves the last application of M: one in five where systems are solved roughly. Conjugate gradients are the
  // same on both sides, but on the left Belos applies M once more, to a first residual that nobody reads.
  if (m) problem->setRightPrec(Teuchos::rcp(new PreconditionerOperator(m, b->getMap())));
  if (symmetric) problem->setHermitian();
  problem->setProblem();

  const auto list = asked_of_belos(given, symmetric, relative_tolerance, largest_iterations);
  if (manager.is_null()) {
    Belos::SolverFactory<double, TpetraMultiVector, TpetraOperator> factory;
    manager = factory.create(method, list);
  } else {
    manager->setParameters(list);
  }
  manager->setProblem(problem);
  LinearSolveResult result;
  const TpetraVector start(*x, Teuchos::Copy);
  try {
    result.converged = manager->solve() == Belos::Converged;
  } catch (const Belos::BelosError& error) {
    // Curvature or directions lost to round-off, which all ranks see alike in the same sums; x holds what was reached.
    result.failure = method + " stopped: " + last_line(error.what());
  } catch (const SolverFailure& error) {  // of all ranks
    result.nothing = differ_by_nothing(*x, start);
    result.failure = method + " stopped: " + last_line(error.what());
  } catch (const std::exception& error) {
    // A library has failed in the preconditioner. Other ranks know nothing of it, and wait for this one.
    if (is_out_of_memory(error) || is_our_mistake(error) || a->getDomainMap()->getComm()->getSize() > 1) throw;
    result.nothing = differ_by_nothing(*x, start);
    result.failure = method + " stopped: " + last_line(error.what());
  }
  result.iterations = manager->getNumIters();
  if (!result.converged && result.failure.empty())
    result.failure =
        method + " did not reach " + number_text(relative_tolerance) + " in " + counted(result.iterations, "iteration");
  // A part of one rank that failed is not a number, and so is this norm, on all ranks.
  if (!result.converged && !std::isfinite(x->norm2())) {
    Tpetra::deep_copy(*x, start);
    result.nothing = true;
    result.failure = method + " met a number that is none: a part of the preconditioner failed";
  }
  // The manager stays, the matrix and its factors must not: the next system is built when this one is gone.
  manager->setProblem(Teuchos::rcp(new Data::Problem));
  return result;
}

}  // namespace voussoir
