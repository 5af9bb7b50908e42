// The bonded continuum: the structure with every joint tied, preconditioned once by MueLu
// (factored where it is too small for more than one level, or stones differ too much in stiffness).
//
// For joints that are infinitely stiff while closed, the homogenised structure is the structure without joints.
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <memory>

#include "homogenisation/coarse_operator_parameters.hpp"
#include "homogenisation/merged_space.hpp"
#include "linalg/amg_preconditioner.hpp"

namespace voussoir {

class Continuum {
 public:
  /// @param local_stiffness  of points [N/m]: those that cannot be tied are springs as stiff as the stones beside them
  Continuum(const BlockSystem&, const ContactPoints&, const Held& held, const Teuchos::ParameterList& muelu,
            const CoarseOperatorParameters& = {}, const std::vector<double>& local_stiffness = {});

  const MergedSpace& space() const { return *space_; }
  /// What is preconditioned: of blocks as they are where it is factored for its size, else of what is sparse of them.
  const Teuchos::RCP<TpetraMatrix>& matrix() const { return matrix_; }
  /// None where multigrid fails and the continuum is too large to be factored.
  const std::shared_ptr<const Preconditioner>& preconditioner() const { return preconditioner_; }
  /// Of its multigrid, from the finest to the coarsest; none where it is factored. Collective.
  std::vector<MultigridLevel> levels() const;

 private:
  void make_multigrid(const BlockSystem&, const Teuchos::ParameterList& muelu);

  std::unique_ptr<MergedSpace> space_;
  Teuchos::RCP<TpetraMatrix> matrix_;
  std::shared_ptr<const AmgPreconditioner> multigrid_;
  std::shared_ptr<const Preconditioner> preconditioner_;
};

/// The continuum seen from a selection: every unknown follows the continuum's at its place.
/// Adds P A^-1 P^T r, A^-1 being one V-cycle.
class ContinuumCorrection {
 public:
  ContinuumCorrection(const Continuum&, const MergedSpace& selection);
  void add(const TpetraVector& r, TpetraVector& z) const;

 private:
  const Continuum& continuum_;
  std::vector<int> from_;  ///< per owned unknown: unknown of the continuum's column map, -1 where either is held
  Teuchos::RCP<TpetraVector> ghosted_, coarse_r_, coarse_z_;
};

}  // namespace voussoir
