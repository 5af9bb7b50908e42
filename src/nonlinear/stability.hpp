// Is an equilibrium with joints that soften one that a structure can take?
//
// With points as they stand (closed and sticking ones rigid, friction held at its size) a motion v takes the work
//
//   v.K v - sum over softening points h (B v)^2           h > 0: slope by which their forces fall
//
// of second order. Where it is negative for some v the structure leaves the state on its own along v: of cracks that
// soften side by side one runs on and others close. That is told by the largest share of softening
//
//   mu = max  sum h (B v)^2 / (v.K v + sum h (B v)^2)     stable where mu < 1/2; excess = 2 mu - 1
//
// which is the largest eigenvalue of h^1/2 B A^-1 B^T h^1/2 with A = K + B^T h B, a matrix with as many rows as points
// soften; Lanczos' method finds it by linear solves with A, whose matrix is one of springs.
//
// Theory   R. Hill, J. Mech. Phys. Solids 6 (1958) 236-249 (comparison solid); Z. P. Bazant, L. Cedolin, Stability of
//          Structures (1991), chapters 10, 13 (which branch a structure takes).
#pragma once

#include "nonlinear/first_of_alike.hpp"
#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/stability_parameters.hpp"

namespace voussoir {

/// A motion along which a state gives way.
struct Instability {
  bool any = false;       ///< the state gives way on its own
  double excess = 0;      ///< [-] of softening over stiffness, relative to their sum: -1 to 1
  long long leader = -1;  ///< number of the point that softens fastest there, the lowest of those that are alike
  FirstOfAlike runs_on;   ///< the joint that runs on there, where it is one; else -1
  Teuchos::RCP<TpetraVector> motion;  ///< [m] in which that point opens or slips on; the largest such motion is 1
  PointField gaps;                    ///< [m] of the motion
};

/// @param x, lambda, damage  an equilibrium, with the damage of the start of its step or beyond
/// @param report             gains what is done
/// Collective. Without points that soften nothing is solved.
Instability find_instability(NonlinearProblem&, const TpetraVector& x, const PointField& lambda, const Damage& damage,
                             NewtonReport& report);

/// Goes along a motion as far as the potential of the step falls: the forces of the law at the gaps of the way are
/// those of points that resist with their local stiffness. Collective.
/// @param sign    1 or -1
/// @param lambda  becomes what the law gives there
/// @return the way gone [m]
double go_down(NonlinearProblem&, const Instability&, double sign, const Damage&, TpetraVector& x, PointField& lambda);

}  // namespace voussoir
