// What the nonlinear solver sees. Here the dimension of space ends: above are vectors, points and numbers.
#pragma once

#include <limits>
#include <vector>

#include "joints/contact_law.hpp"
#include "joints/damage.hpp"
#include "joints/point_freedom.hpp"
#include "linalg/linear_solve_result.hpp"
#include "linalg/types.hpp"
#include "nonlinear/point_field.hpp"

namespace voussoir {

class PatchSource;

/// Compliances of a structure whose joints have no mortar: none.
inline const std::vector<PointCompliance>& no_mortar() {
  static const std::vector<PointCompliance> none;
  return none;
}

/// How a linear system is to be solved.
struct SolveRequest {
  double tolerance;        ///< relative to the right-hand side
  int largest_krylov = 0;  ///< 0 = as many iterations as the scene allows
};

/// Equilibrium K u - f = B^T lambda of one load step with the contact law at its selected points.
///
/// Point fields cover this rank's points and ghosts; each owner and its ghosts compute the same bits,
/// so contact forces are never communicated. Sums over points run over owned points.
class NonlinearProblem {
 public:
  virtual ~NonlinearProblem() = default;

  virtual Teuchos::RCP<const TpetraMap> map() const = 0;
  virtual int components() const = 0;
  virtual int points() const = 0;
  virtual int owned_points() const = 0;
  /// Number of a point, the same for any number of ranks.
  virtual long long number_of(int point) const { return point; }
  /// Number of its joint on this rank, where all points of a joint are, or none.
  virtual int joint_of(int point) const { return point; }
  /// 1 where the point is resolved as contact; the others are tied and skipped.
  virtual const std::vector<char>& selected() const = 0;
  /// At the start of the step; of points that soften CurrentLaws tells more.
  virtual const PointLaws& law() const = 0;
  /// Points that lose strength as they open or slip; null where there are none. Their damage is part of the state, and
  /// is handed to whoever asks for laws.
  virtual const SofteningPoints* softening() const { return nullptr; }
  /// Stiffness of the blocks as a point sees it [N/m]: the natural augmentation.
  virtual const std::vector<double>& local_stiffness() const = 0;
  /// Mortar of each point; empty when stone meets stone everywhere.
  virtual const std::vector<PointCompliance>& compliance() const { return no_mortar(); }
  /// Slip at the start of the load step [m], normal component 0; empty when it is 0 everywhere, or nothing rubs.
  virtual const PointField& slip_origin() const = 0;

  /// r = K R x - f, on unknowns; held rows 0. Also the gaps g [m] of x.
  virtual void evaluate(const TpetraVector& x, TpetraVector& r, PointField& gap) = 0;
  /// y = K R d and the gaps of a direction d (no loads, no initial gaps).
  virtual void evaluate_direction(const TpetraVector& d, TpetraVector& y, PointField& gap) = 0;
  /// The gaps of the nearest motion to d in which every block moves as a whole; returns how far d is from it [m].
  /// Infinitely far where nothing is known of blocks. Collective.
  virtual double rigid_gaps(const TpetraVector& /*d*/, PointField& /*gap*/) {
    return std::numeric_limits<double>::infinity();
  }
  /// Where round-off of x makes forces that are not small beside a tolerance [N], stones are carried: they stay where x
  /// has them, x becomes 0, and what they moved as wholes makes no forces any more, nor round-off. Returns whether.
  /// Collective.
  virtual bool carry(TpetraVector& /*x*/, double /*tolerance*/) { return false; }
  /// Sum of all x that were carried; null when there was none.
  virtual const TpetraVector* carried() const { return nullptr; }
  /// r -= B^T lambda.
  virtual void subtract_contact_forces(const PointField& lambda, TpetraVector& r) = 0;
  /// Proximal weight of each owned unknown [N/m], the size at which it matters as much as the structure's stiffness.
  virtual const std::vector<double>& proximal_weight() const = 0;
  /// Solves (K + resistance + scale x proximal) d = b from the given d. Collective, and the same answer on all ranks.
  [[nodiscard]] virtual LinearSolveResult solve(const std::vector<PointStiffness>&, double proximal_scale,
                                                const Teuchos::RCP<TpetraVector>& b,
                                                const Teuchos::RCP<TpetraVector>& d, const SolveRequest&) = 0;
  /// Where forces may run round between stones that meet, so that neither equilibrium nor motion tells their split:
  /// makes it the one that is unique (joints/shared_forces.hpp), where springs and the law do not. Collective.
  virtual void split_shared_forces(const std::vector<PointFreedom>&, SharedFriction, PointField& /*lambda*/) const {}
  /// Whether it does anything on some rank.
  virtual bool shares_forces() const { return false; }
  /// From where stuck stones are cut, or null where they cannot be.
  virtual PatchSource* patches() { return nullptr; }
  /// What residuals of the state evaluated last may be by round-off alone [N]: that of the sums that make them, of
  /// stiffness times displacement at each node and of resistance times motion at each point. 0 where it is not known.
  /// Collective.
  virtual double round_off() const { return 0; }
  /// Largest force in play [N]: what residuals are measured against.
  virtual double force_scale() const = 0;
  /// Size of the structure [m]: what run-away displacements are measured against.
  virtual double length_scale() const = 0;
};

}  // namespace voussoir
