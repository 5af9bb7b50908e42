// Direct solution of unsymmetric systems on one rank: UMFPACK behind a wall.
#pragma once

#include <memory>

#include "linalg/local_csr.hpp"

namespace voussoir {

/// LU factors of a sparse square matrix of one rank. The pattern is ordered once for all matrices that have it.
class SparseLu {
 public:
  /// Rows up to which callers ask for it: UMFPACK counts its memory in 32 bits, and finds no room for many more rows
  /// where most points are closed.
  static constexpr int most_rows = 200000;

  SparseLu();
  ~SparseLu();

  /// Factors a matrix, of the pattern of the first one given. Whatever else UMFPACK objects to is a SolverFailure.
  /// @return false where A is singular
  [[nodiscard]] bool factor(const LocalCsr& a);
  /// x = A^-1 b, both [rows]; x must not be b.
  /// @param a  what was factored last
  /// @return false, and x anything, where A is singular
  [[nodiscard]] bool solve(const LocalCsr& a, const double* b, double* x) const;
  /// Held by UMFPACK.
  long long bytes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace voussoir
