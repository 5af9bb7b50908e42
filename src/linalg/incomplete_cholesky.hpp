// Approximate factors of the rows and columns that a rank owns, in the pattern of the matrix: a smoother of levels.
#pragma once

#include <vector>

#include "linalg/types.hpp"

namespace voussoir {

/// A = U^T D U, U with ones on its diagonal, entries outside of the pattern of A left out (J. A. Meijerink,
/// H. A. van der Vorst, Math. Comput. 31 (1977) 148-162). Where that leaves a pivot that is none, diagonal entries are
/// raised by a share of themselves (T. A. Manteuffel, Math. Comput. 34 (1980) 473-497).
class IncompleteCholesky {
 public:
  /// @param a  symmetric; local columns of owned unknowns first and in the order of rows
  explicit IncompleteCholesky(const TpetraMatrix& a);
  /// z = A^-1 r, nearly, of this rank's unknowns; r may be z.
  void solve(const double* r, double* z) const;
  long long bytes() const;

 private:
  bool factor(const std::vector<double>& diagonal);

  std::vector<int> start_{0}, column_;  ///< of the rows of U behind its diagonal
  std::vector<double> value_, pivot_;   ///< U, and 1 / D
};

}  // namespace voussoir
