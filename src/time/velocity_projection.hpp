// The velocity nearest to a given one, in the norm of the kinetic energy, without relative velocities at some points.
//
// Impulses lambda act at points that are held: v' = v - M^-1 B^T lambda with (B M^-1 B^T) lambda = B v. Mass couples
// the nodes of a block only, so M^-1 is one small solve for each block, factored once, and as an impulse hardly moves
// what is not next to it, conjugate gradients take as many iterations for a bridge as for an arch.
//
// Supports keep their velocity, however they move; what that takes of them are impulses too, M dv + B^T lambda at the
// components they hold. They belong to what a support bears, and where it moves they do work, which the kinetic energy
// alone does not tell from a loss.
#pragma once

#include <memory>

#include "linalg/linear_solver.hpp"
#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

/// B v: relative velocities of contact points along their axes [m/s, points x components].
PointField relative_velocities(const ContactPoints&, const std::vector<double>& velocity);

/// Impulses of a change of velocities.
struct JumpImpulses {
  std::vector<double> of_supports;  ///< [N s, node copies] M dv - B^T p: round-off where nothing is held
  PointField at_points;             ///< [N s] p, along the axes of points; normal ones press where they are positive
};

class VelocityProjection {
 public:
  /// @param mass  the structure with the mass of its blocks in the place of their stiffness
  VelocityProjection(const Model&, const BlockSystem& mass);
  ~VelocityProjection();

  /// What resists an impulse at a point along its axis, of its two nodes alone [kg]; 0 where supports hold both.
  double mass(int point, int axis) const;

  /// Collective; SolverFailure on all ranks where the impulses are not found.
  /// @param velocity  [m/s] on node copies, ghosts up to date; changed
  /// @param held      1 where relative velocities become zero [points x components]; ghosts as their owners
  /// @return none where the velocity was right
  JumpImpulses apply(std::vector<double>& velocity, const std::vector<char>& held);
  /// Adds what impulses at points [N s, points x components; ghosts as their owners] do to velocities. Returns the
  /// impulses of supports [N s, node copies]. Collective.
  std::vector<double> push(std::vector<double>& velocity, const PointField& impulses);

 private:
  class Impulses;
  class ByMass;
  Impulses& impulses();
  std::vector<double> add(std::vector<double>& velocity, const TpetraVector& lambda);
  const Model& model_;
  const BlockSystem& mass_;
  LinearSolver solver_;
  Teuchos::RCP<Impulses> impulses_;  ///< from the first projection on: a run without impacts factors no mass
  std::shared_ptr<ByMass> by_mass_;
};

}  // namespace voussoir
