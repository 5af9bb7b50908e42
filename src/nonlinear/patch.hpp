// A few stones whose surroundings hold still: a contact problem of its own, small enough for direct solution.
//
// Where a handful of stones keeps all others from closing, they are brought to rest alone: by active sets, or along the
// interior path.
// Unknowns are displacements from where the stones are. Between two stones of the patch the contact law holds. Points
// at its border stay closed or open as in the last linear solve: under the law, a node that touches two stones which
// hold still a little apart would give its whole force to one of them.
//
// Theory   P. J. Lanzkron, D. J. Rose, J. T. Wilkes, SIAM J. Sci. Comput. 17 (1996) 538-559 (nonlinear elimination);
//          X.-C. Cai, D. E. Keyes, SIAM J. Sci. Comput. 24 (2002) 183-200.
#pragma once

#include "linalg/local_csr.hpp"
#include "linalg/sparse_lu.hpp"
#include "nonlinear/method_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/patch_parts.hpp"

namespace voussoir {

class Patch : public NonlinearProblem {
 public:
  explicit Patch(PatchParts, const MethodParameters& = {});

  /// Brings the stones to rest; false when they find none.
  /// @param tolerance  relative to the largest force of the structure
  bool solve(double tolerance, NewtonReport&);
  /// Largest change of a force at the border [N]: what the surroundings have to bear instead.
  double passed_on() const { return passed_on_; }
  /// How far each unknown was moved [m].
  const std::vector<double>& displacement() const { return displacement_; }
  /// What became of the points, forces alone.
  const std::vector<PatchPoint>& solved_points() const { return parts_.points; }
  const std::vector<PatchPoint>& solved_border() const { return parts_.border; }

  Teuchos::RCP<const TpetraMap> map() const override { return map_; }
  int components() const override { return parts_.components; }
  int points() const override { return static_cast<int>(parts_.points.size()); }
  int owned_points() const override { return points(); }
  const std::vector<char>& selected() const override { return selected_; }
  const PointLaws& law() const override { return law_; }
  const std::vector<double>& local_stiffness() const override { return local_stiffness_; }
  const std::vector<PointCompliance>& compliance() const override { return compliance_; }
  const PointField& slip_origin() const override { return slip_origin_; }
  void evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) override;
  void evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) override;
  void subtract_contact_forces(const PointField& lambda, TpetraVector& r) override;
  const std::vector<double>& proximal_weight() const override { return parts_.proximal_weight; }
  /// Directly, whatever the tolerance.
  LinearSolveResult solve(const std::vector<PointStiffness>&, double proximal_scale,
                          const Teuchos::RCP<TpetraVector>& b, const Teuchos::RCP<TpetraVector>& d,
                          const SolveRequest&) override;
  double force_scale() const override { return parts_.force_scale; }
  double length_scale() const override { return parts_.length_scale; }

 private:
  void set_pattern();
  bool come_to_rest(TpetraVector& x, PointField& lambda, double tolerance, NewtonReport&);
  void yield_at_the_border();
  void add(const PatchPoint&, const PointStiffness&, LocalCsr& to) const;
  double& entry(LocalCsr&, int row, int column) const;

  PatchParts parts_;
  MethodParameters methods_;
  Teuchos::RCP<const TpetraMap> map_;
  std::vector<char> selected_;
  PointLaws law_;
  std::vector<double> local_stiffness_, displacement_;
  std::vector<PointCompliance> compliance_;
  PointField slip_origin_;
  LocalCsr stiffness_;  ///< of blocks and border; with places for the points
  SparseLu factor_;
  double passed_on_ = 0;
};

}  // namespace voussoir
