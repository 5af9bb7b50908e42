// Direct solution of symmetric positive definite systems on one rank: CHOLMOD behind a wall.
#pragma once

#include <memory>
#include <vector>

#include "linalg/local_csr.hpp"

namespace voussoir {

/// Cholesky factors of a symmetric matrix of one rank, of which the upper triangle is given: each row begins with its
/// diagonal entry. CHOLMOD reads it where it stands.
class SparseCholesky {
 public:
  /// Factors A. A pivot that is not positive is repaired by adding
  /// 1e-10 of the diagonal: A may be singular by rigid motions. Where it is indefinite by more than round-off, or
  /// CHOLMOD objects to anything else but a lack of memory, SolverFailure is thrown.
  explicit SparseCholesky(const LocalCsr& a);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Factors another matrix of the same pattern, without ordering it again. Fails likewise; the next one may succeed.
  void refactor(const LocalCsr& a);

  int size() const;
  /// Held by CHOLMOD.
  long long bytes() const;
  /// x = A^-1 b, both [size] column by column; x may be b.
  void solve(const double* b, double* x, int columns = 1) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace voussoir
