// Krylov solution of the block-level system: Belos behind a wall.
#pragma once

#include <memory>

#include "linalg/linear_solve_result.hpp"
#include "linalg/preconditioner.hpp"
#include "linalg/solver_parameters.hpp"

namespace voussoir {

/// Of a system; without symmetry another Krylov method is needed.
enum class Symmetry { symmetric, none };

class LinearSolver {
 public:
  explicit LinearSolver(const SolverParameters&);
  ~LinearSolver();

  /// Solves A x = b from the given x until |b - A x| <= relative_tolerance |b|.
  /// M may be null. Every rank calls it.
  /// @param largest_iterations  of this solve, where fewer are wanted than the parameters allow; 0 = those
  [[nodiscard]] LinearSolveResult solve(const Teuchos::RCP<const TpetraOperator>& a,
                                        const std::shared_ptr<const Preconditioner>& m,
                                        const Teuchos::RCP<const TpetraVector>& b, const Teuchos::RCP<TpetraVector>& x,
                                        double relative_tolerance, Symmetry = Symmetry::symmetric,
                                        int largest_iterations = 0);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace voussoir
