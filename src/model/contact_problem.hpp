// The equilibrium of one step with one selection, as the nonlinear solver sees it. It lives as long as its selection:
// unknowns, pattern, orders and factors serve all steps in between.
#pragma once

#include <memory>
#include <optional>

#include "homogenisation/coarse_operator.hpp"
#include "joints/shared_forces.hpp"
#include "linalg/linear_solver.hpp"
#include "model/contact_state.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/stuck_stones.hpp"
#include "scene/internals.hpp"

namespace voussoir {

class ContactProblem : public NonlinearProblem {
 public:
  /// What stays the same through all load steps; must outlive the problem.
  struct Parts {
    const BlockSystem& structure;
    const ContactPoints& points;
    const Continuum& continuum;
    const Held& held;
    const std::vector<double>& local_stiffness;  ///< per point [N/m]
    const std::vector<double>& initial_gap;      ///< per point [m], empty when all joints are closed at first
    const PreconditionerParameters& preconditioner;
    const Internals& internals;
    LinearSolver& solver;
    /// Per point, empty without mortar.
    const std::vector<PointCompliance>& compliance = no_mortar();
    double softest_mortar = std::numeric_limits<double>::infinity();  ///< [Pa/m] of all joints, the same on every rank
    bool inertia = false;  ///< in the matrices of blocks: then motions as wholes make forces too
  };

  /// What one step asks of it; must outlive the step.
  struct Asked {
    const PointLaws& law;
    const PointField& slip_origin;
    const std::vector<double>& load;             ///< nodal forces [N, components x local node copies]
    const std::vector<double>& prescribed;       ///< displacement of held components [m], the same shape
    const SofteningPoints* softening = nullptr;  ///< null where no joint can lose strength
    /// [N] what points bore at the start of the step. Residuals are measured against a small share of that at least: of
    /// a structure that is let go nothing but round-off is left in the end.
    const PointField* borne = nullptr;
  };

  /// Unknowns, matrix and preconditioner of a selection. Collective.
  ContactProblem(const Parts&, const std::vector<char>& selected, const Asked&);
  /// Goes on with another step, which is solved as by a new problem: what stays is what would be made alike again.
  /// Collective.
  void begin(const Asked&);

  /// 1 where a point is selected, as it was made for.
  const std::vector<char>& selection() const { return selection_; }

  const Parts& parts() const { return parts_; }
  const MergedSpace& space() const { return *space_; }
  /// Unknowns from a displacement, held ones at their prescribed values.
  Teuchos::RCP<TpetraVector> unknowns(const std::vector<double>& displacement) const;
  /// The displacement of all local node copies, what was carried included.
  void displacement(const TpetraVector& x, std::vector<double>& u) const;

  Teuchos::RCP<const TpetraMap> map() const override { return space_->map(); }
  int components() const override { return dim_; }
  int points() const override { return parts_.points.size(); }
  int owned_points() const override { return parts_.points.owned(); }
  long long number_of(int point) const override { return parts_.points.points()[point].id; }
  int joint_of(int point) const override { return parts_.points.points()[point].joint; }
  /// Without points whose force nothing determines, as supports hold both sides or other joints tie them, and those not
  /// built yet.
  const std::vector<char>& selected() const override { return movable_; }
  const PointLaws& law() const override { return asked_->law; }
  const SofteningPoints* softening() const override { return asked_->softening; }
  const std::vector<double>& local_stiffness() const override { return parts_.local_stiffness; }
  const std::vector<PointCompliance>& compliance() const override { return parts_.compliance; }
  const PointField& slip_origin() const override { return asked_->slip_origin; }
  void evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) override;
  void evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) override;
  double rigid_gaps(const TpetraVector& d, PointField& gap) override;
  bool carry(TpetraVector& x, double tolerance) override;
  const TpetraVector* carried() const override { return carried_.get(); }
  void subtract_contact_forces(const PointField& lambda, TpetraVector& r) override;
  const std::vector<double>& proximal_weight() const override { return proximal_weight_; }
  LinearSolveResult solve(const std::vector<PointStiffness>&, double proximal_scale,
                          const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                          const SolveRequest&) override;
  void split_shared_forces(const std::vector<PointFreedom>&, SharedFriction, PointField& lambda) const override;
  bool shares_forces() const override { return shares_; }
  /// None in space.
  PatchSource* patches() override;
  const SystemMatrix& system() const { return *matrix_; }
  const CoarseOperator& preconditioner() const { return *coarse_; }
  /// What its solves took besides Krylov iterations.
  SystemCost cost() const { return coarse_->cost(); }
  /// In time displacements are those of the step. At rest what they move stones by as wholes is carried where it tells,
  /// and what then deforms them is left.
  double round_off() const override;
  /// The largest load, or without loads the forces that prescribed displacements cause; next to nothing beside what was
  /// borne, or beside what these displacements could cause, counts as such a share of that.
  double force_scale() const override { return std::max(force_scale_ > 0 ? force_scale_ : internal_scale_, borne_); }
  double length_scale() const override { return parts_.structure.size(); }

 private:
  void gaps(PointField& gap, bool initial) const;
  Symmetry set_up(const std::vector<PointStiffness>&, double proximal_scale);
  void make_preconditioner();
  void set_scales();
  void set_absolute_terms(const std::vector<double>& displacement);
  void set_proximal_weights();
  double stiffest_that_counts(double volume) const;
  void set_movable();
  void find_shared_forces();

  Parts parts_;
  const int dim_;              ///< components of displacements
  bool has_own_axes_ = false;  ///< some node of any rank is held along a normal
  const std::vector<char> selection_;
  std::optional<Asked> asked_;
  std::unique_ptr<MergedSpace> space_;
  std::unique_ptr<SystemMatrix> matrix_;
  std::shared_ptr<CoarseOperator> coarse_;
  std::vector<char> movable_;
  std::vector<double> proximal_weight_, copies_, forces_;
  // What was carried, and of the node copies where x is 0 [m]: motions of blocks as wholes, their gaps, and the rest;
  // empty before.
  Teuchos::RCP<TpetraVector> carried_;
  std::vector<double> rigid_, rigid_gap_, deformed_;
  double force_scale_ = 0, internal_scale_ = 0, borne_ = 0, stiffest_ = 0;
  std::vector<double> row_sum_;  ///< [N/m] of each block, the largest sum of absolute values in a row of its matrix
  double absolute_terms_ = 0;    ///< [N] largest sum of absolute values of what makes a force within a block
  std::unique_ptr<SharedForces> shared_forces_;  ///< none where no joint softens
  bool shares_ = false;                          ///< some rank has such places
  std::unique_ptr<PatchSource> patches_;         ///< none as long as nothing was stuck
};

}  // namespace voussoir
