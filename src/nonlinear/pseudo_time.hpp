// Pseudo-time: stones sink through something viscous until they rest, or fall without end.
//
// Where no way through the contact conditions arrives, the structure is let go from where it is. Every node moves
// against a drag c w (x - x_old), w the proximal weight of the problem, and each step is a contact problem whose stones
// nothing lets fly, which active sets solve as they solve time steps. The drag falls by a factor after each step that
// arrives and rises after one that does not. At rest nothing is left of it: that is equilibrium. A structure that has
// none keeps moving, with forces that obey the contact law and an imbalance that stays: its motion is then asked
// whether it leads anywhere.
//
// Ends   At the start and after every step that arrives the state is judged without drag: equilibrium and contact
//        (residuals.hpp), by the largest force in play. A step itself ends at a tenth (accuracy) of the size before it,
//        of the largest force at most, drag included; or at the tolerance where that is more.
//        converged      their size is no more than the tolerance
//        collapse       a step has left the size above half (unchanged) of what it was and above the tolerance, contact
//                       is below 1e-2 (believable), and its motion leads nowhere: it was a fifth (run away) of the
//                       structure, or so far along it no component of the imbalance changes by more than half of the
//                       largest, nor does the law ask for more; of blocks as wholes kinematics tells it
//                       (rigid_mechanism.hpp)
//        not_converged  no linear solves are left, or a library has refused two steps since the last that arrived
//        stopped        whoever watches wanted no more
// Back   x and lambda after the last step that arrived; stopped, where active sets were.
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
  void integrate(TpetraVector& x, PointField& lambda, double tolerance, const PointField* known_gap, int largest_solves,
                 NewtonReport& report);

  /// Displacement of the last step, scaled to a largest component of 1.
  const TpetraVector& mechanism() const { return *mechanism_; }

 private:
  double measure(const TpetraVector& x, const PointField& lambda, NewtonReport&);
  bool leads_nowhere(const TpetraVector& x, const TpetraVector& from, const PointField& lambda);

  NonlinearProblem& problem_;
  NewtonParameters parameters_;
  const MethodParameters methods_;
  const Strength strength_;
  Teuchos::RCP<TpetraVector> mechanism_, imbalance_;
  PointField gap_;
  double scale_ = 1;  ///< [N]
};

}  // namespace voussoir
