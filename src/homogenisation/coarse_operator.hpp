// The preconditioner of the block-level system: block-local solves, the homogenised continuum, block motions.
//
//   M r = Q r + (I - Q H) N (I - H Q) r,   Q = Z (Z^T H Z)^-1 Z^T                  (block motions, exact)
//   I - N H = (I - w S H) (I - C H) (I - w S H)                                   (blocks, continuum, blocks)
//
// Symmetric, so conjugate gradients stay conjugate gradients. w = 1/2: every contact couples two blocks, so no
// eigenvalue of S H exceeds 2. GMRES needs no symmetry, and M r = N r + Q (r - H N r) does with one solve of block
// motions and one product with H less. Parts that are switched off, or that a selection does not need, are left out.
// Where that labours H is factored whole, friction included: whole.md.
#pragma once

#include <memory>

#include "homogenisation/block_motions.hpp"
#include "homogenisation/block_solves.hpp"
#include "homogenisation/coarse_operator_parameters.hpp"
#include "homogenisation/continuum.hpp"
#include "homogenisation/preconditioner_parameters.hpp"
#include "homogenisation/released_region.hpp"
#include "linalg/distributed_lu.hpp"
#include "linalg/linear_solver.hpp"
#include "linalg/system_cost.hpp"

namespace voussoir {

class CoarseOperator : public Preconditioner {
 public:
  CoarseOperator(const BlockSystem&, const ContactPoints&, const std::vector<char>& selected, const MergedSpace&,
                 const Continuum&, const PreconditionerParameters&, const CoarseOperatorParameters& = {});

  /// Takes over new statuses; H is the system they belong to. Factors stay where no resistance has changed by more than
  /// a tenth. Collective, as is a SolverFailure of this and of couple.
  void update(const SystemMatrix& h, const std::vector<PointStiffness>&, const std::vector<double>& proximal);
  /// A step begins, with H of the same pattern. What the step before has learnt is forgotten, so that this one does not
  /// depend on whether there was one; factors stay where no resistance changes at all. Whether that goes: not where H
  /// was factored whole.
  bool begin_step();
  /// Takes over the couplings that H has got since, and the symmetry of the method that will apply this. Collective.
  void couple(const SystemMatrix& h, Symmetry);
  /// Whether H could be factored whole and is not yet: few enough unknowns, some of which a selection has parted.
  bool may_factor_whole() const;
  /// Krylov iterations that take as long as factoring H, at least those of the settings. Without end where its factors
  /// would be too large, or MUMPS failed: the parts then stay. Collective.
  int iterations_of_factoring();
  /// Factors H, and every H that update takes over from here on, instead of all parts. Returns false where there was
  /// no room, or MUMPS failed: the parts then stay, and H is not factored whole any more. Collective.
  bool factor_whole();
  /// From here on H is factored whole on the first rank alone where it is, and so are block motions: the same bits in
  /// every run.
  void factor_on_first_rank();
  void apply(const TpetraVector& r, TpetraVector& z) const override;
  /// Unknowns of the block motions.
  long long motions() const { return motions_ ? motions_->size() : 0; }
  /// Of groups of blocks above them, from the finest to the coarsest; none where they are factored. Collective.
  std::vector<MultigridLevel> motion_levels() const;
  /// Counts since the beginning; bytes held at present.
  SystemCost cost() const;

 private:
  bool parted() const;
  bool order_whole();
  bool changed(const std::vector<PointStiffness>&, const std::vector<double>& proximal) const;
  bool differ(double a, double b) const;
  void leave(const TpetraVector& r, const TpetraVector& z, TpetraVector& left) const;
  void apply_inner(const TpetraVector& r, TpetraVector& z) const;
  void apply_around_region(const TpetraVector& r, TpetraVector& z) const;

  const CoarseOperatorParameters numbers_;
  const BlockSystem& structure_;
  const MergedSpace& space_;
  int factored_up_to_;  ///< unknowns
  bool whole_fails_ = false;
  FactorsAre factors_are_ = FactorsAre::spread;
  std::unique_ptr<BlockMotions> motions_;
  std::unique_ptr<BlockSolves> blocks_;
  std::unique_ptr<ContinuumCorrection> continuum_;
  std::unique_ptr<ReleasedRegion> region_;  ///< instead of motions and blocks
  std::unique_ptr<DistributedLu> whole_;    ///< instead of all of them
  std::unique_ptr<DistributedLu> ordered_;  ///< which that may come to be
  bool factored_ = false;                   ///< motions and blocks are, as the members below say
  bool stale_ = true;                       ///< statuses have changed since region or whole were factored
  bool begins_ = false;                     ///< the step has solved no system yet
  Teuchos::RCP<const TpetraMatrix> h_;
  Symmetry symmetry_ = Symmetry::symmetric;
  const std::vector<char>& selected_;
  std::vector<PointStiffness> factored_stiffness_;  ///< what the factors belong to
  std::vector<double> factored_proximal_;
  SystemCost cost_;
  mutable TpetraVector residual_, product_, inner_, inner_residual_;
};

}  // namespace voussoir
