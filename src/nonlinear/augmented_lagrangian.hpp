// Closing the contact conditions: proximal augmented Lagrangian outside, semismooth Newton with exact line
// search inside. It cannot cycle where plain active sets do.
//
//   minimise over x   1/2 x.K x - f.x + sum 1/(2 sigma) |[p - sigma g_N]_+|^2 + friction term + prox/2 |x - x_k|^2
//   then              p <- [p - sigma g_N]_+,   q <- projection of q - sigma g_T on the disc of radius mu p
//
// Theory   R. T. Rockafellar, Math. Oper. Res. 1 (1976) 97-116 (proximal multipliers);
//          P. Alart, A. Curnier (1991) for the friction cone. Decisions: README.md of this folder.
#pragma once

#include <functional>

#include "nonlinear/augmented_lagrangian_parameters.hpp"
#include "nonlinear/newton_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

class AugmentedLagrangian {
 public:
  AugmentedLagrangian(NonlinearProblem&, const NewtonParameters&, const AugmentedLagrangianParameters&);

  /// Called after each linear solve; may be empty.
  std::function<void(const NewtonProgress&)> narrate;

  /// Solves from x (held unknowns already at their prescribed values) and contact forces lambda [N].
  /// @param tolerance  Karush-Kuhn-Tucker residual relative to the largest force; may be looser than the parameters'
  /// @param known_gap  gaps of a state in equilibrium with lambda; when given, the first linear solve moves from there
  ///                   with its statuses, whatever prescribed displacements have done to x. May be null
  /// On collapse x holds the run-away state and mechanism() its direction.
  NewtonReport solve(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap = nullptr);

  /// Displacement of the last outer iteration, scaled to a largest component of 1.
  const TpetraVector& mechanism() const { return *mechanism_; }

 private:
  struct State;
  int minimise(State&, double tolerance, NewtonReport&);
  void predict(State&, const PointField& known_gap, NewtonReport&);
  void solve_direction(State&, double relative_tolerance, NewtonReport&);
  double line_search(State&);
  void anticipate(State&) const;
  double update_forces(State&) const;
  void measure(State&, NewtonReport&) const;
  bool moved_far(State&) const;
  bool runs_away(State&) const;

  NonlinearProblem& problem_;
  NewtonParameters parameters_;
  AugmentedLagrangianParameters numbers_;
  Teuchos::RCP<TpetraVector> mechanism_;
};

}  // namespace voussoir
