// Pseudo-time: stones sink through something viscous until they rest, or fall without end.
//
// Where no way through the contact conditions arrives, the structure is let go from where it is. Every node moves
// against a drag c w (x - x_old), w the proximal weight of the problem, and each step is a contact problem whose stones
// nothing lets fly, which active sets solve as they solve time steps. The drag falls by a factor after each step that
// arrives and rises after one that does not. At rest nothing is left of it: that is equilibrium. A structure that has
// none keeps moving, with forces that obey the contact law and an imbalance that stays: its motion is then asked
// whether it leads anywhere.
//
// Theory   C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523 (pseudo-transient continuation).
#pragma once

#include <functional>

#include "nonlinear/method_parameters.hpp"
#include "nonlinear/newton_parameters.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

class PseudoTime {
 public:
  /// @param strength  with its damage where joints soften
  PseudoTime(NonlinearProblem&, const NewtonParameters&, const MethodParameters&, Strength strength = {});

  /// Told and asked after each linear solve; may be empty.
  SolveWatch watch;

  /// Lets the structure go from x (held unknowns at their prescribed values) and contact forces lambda [N].
  /// @param tolerance       Karush-Kuhn-Tucker residual relative to the largest force
  /// @param known_gap       gaps of a state in equilibrium with lambda that supports and loads have left; may be null
  /// @param largest_solves  linear solves after which it gives up
  /// @param report          gains what is done, the residuals, and the outcome
  /// On collapse x holds the run-away state and mechanism() its direction.
  void follow(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap, int largest_solves,
              NewtonReport& report);

  /// Displacement of the last step, scaled to a largest component of 1.
  const TpetraVector& mechanism() const { return *mechanism_; }

 private:
  double measure(const TpetraVector& x, const PointField& lambda, NewtonReport&);
  bool leads_nowhere(const TpetraVector& x, const TpetraVector& from, const PointField& lambda);

  NonlinearProblem& problem_;
  NewtonParameters parameters_;
  const MethodParameters methods_, full_steps_;
  const Strength strength_;
  Teuchos::RCP<TpetraVector> mechanism_, imbalance_;
  PointField gap_;
  double scale_ = 1;  ///< [N]
};

}  // namespace voussoir
