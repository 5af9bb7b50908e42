// Approximate solution of a system of bodies that joints couple: groups of bodies above bodies, groups of those above.
//
//   I - B A = (I - S A) (I - C A) (I - S A)
//
// S are incomplete factors on each rank (incomplete_cholesky.hpp), C a V-cycle of smoothed aggregation on the groups,
// whose motions are those that hardly strain the whole (amg_preconditioner.hpp). B is linear and symmetric.
#pragma once

#include <memory>

#include "linalg/amg_preconditioner.hpp"
#include "linalg/body_levels_parameters.hpp"
#include "linalg/incomplete_cholesky.hpp"

namespace voussoir {

/// What is known of bodies beside their matrix.
struct BodyMotions {
  int of_a_body = 0;                            ///< unknowns, one after the other; none: they are of no bodies
  Teuchos::RCP<TpetraMultiVector> near_null;    ///< what hardly strains the whole
  Teuchos::RCP<TpetraMultiVector> coordinates;  ///< of bodies [m]
};

/// Of the cycle times the matrix, as a few steps of Lanczos see them: not a number where it is none.
struct Eigenvalues {
  double smallest, largest;
};

class BodyLevels : public Preconditioner {
 public:
  /// Collective, as are all others but bytes.
  /// @param a  symmetric positive definite or singular by rigid motions; those of a body on one rank
  BodyLevels(const TpetraMatrix& a, const BodyMotions&, const BodyLevelsParameters& = {});
  void apply(const TpetraVector& r, TpetraVector& z) const override;
  const Eigenvalues& eigenvalues() const { return eigenvalues_; }
  /// Whether the cycle will do in place of the inverse.
  bool converges() const;
  /// From the finest to the coarsest.
  std::vector<MultigridLevel> levels() const { return groups_->levels(); }
  /// On this rank, without what MueLu holds: a few tenths of that.
  long long bytes() const;

 private:
  void measure();

  const BodyLevelsParameters numbers_;
  Teuchos::RCP<TpetraMatrix> a_;
  std::unique_ptr<IncompleteCholesky> smoother_;
  std::unique_ptr<AmgPreconditioner> groups_;
  Eigenvalues eigenvalues_;
  mutable TpetraVector left_, correction_;
};

}  // namespace voussoir
