// Exact solution of a small distributed system: the first rank holds and factors all of it.
//
// For systems so small that multigrid would have one level only, or that to share out their factors costs more than it
// saves; Debian's direct solvers of Trilinos are wrong on a matrix that is spread over ranks.
#pragma once

#include <vector>

#include "linalg/preconditioner.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "linalg/traffic.hpp"

namespace voussoir {

class DirectPreconditioner : public Preconditioner {
 public:
  /// @param a         symmetric positive definite, numbered 0 .. n-1 without gaps in the order of ranks; its upper
  ///                  triangle is read. Collective, as is a SolverFailure of this and of refactor
  /// @param sent_for  what messages of a solution are counted as
  explicit DirectPreconditioner(const TpetraMatrix& a, TrafficOf sent_for = TrafficOf::continuum);
  /// Factors another matrix of the same pattern. Collective.
  void refactor(const TpetraMatrix& a);
  /// Not a number where the first rank cannot solve it.
  void apply(const TpetraVector& r, TpetraVector& z) const override;
  /// On this rank.
  long long bytes() const;

 private:
  LocalCsr whole_of(const TpetraMatrix& a) const;

  Teuchos::RCP<const TpetraMap> map_;
  Teuchos::RCP<const TpetraImport> from_first_;  ///< none on one rank
  TrafficOf sent_for_;
  LocalCsr pattern_;        ///< of the whole on the first rank, empty on others
  std::vector<int> place_;  ///< in it of each entry that comes to the first rank
  std::unique_ptr<SparseCholesky> factor_;
};

}  // namespace voussoir
