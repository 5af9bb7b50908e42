// Exact solution of a small distributed system: every rank holds and factors all of it.
//
// For systems so small that multigrid would have one level only; Debian's direct solvers of Trilinos are wrong
// on a matrix that is spread over ranks.
#pragma once

#include "linalg/preconditioner.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace voussoir {

class DirectPreconditioner : public Preconditioner {
 public:
  /// @param a  symmetric positive definite, numbered 0 .. n-1 without gaps
  explicit DirectPreconditioner(const TpetraMatrix& a);
  void apply(const TpetraVector& r, TpetraVector& z) const override;

 private:
  Teuchos::RCP<const TpetraMap> map_;
  std::unique_ptr<SparseCholesky> factor_;
};

}  // namespace voussoir
