// Karush-Kuhn-Tucker residuals of a state: what is out of balance, and what the contact law would change.
//
//   equilibrium  |K x - f - B^T lambda|               largest of all unknowns, held ones left out [N]
//   contact      |lambda - P(lambda - k (g - g_0))|   largest of all components of selected points [N]; P projects on
//                                                     the law, k is the local stiffness in series with the mortar
//   size         the larger of the two by the largest force in play, 0 where it is round-off of the sums that make it
//
// Every method of this folder ends where the size of its state is no more than the tolerance; its header says which
// forces it judges, and what else ends it.
#pragma once

#include "nonlinear/newton_report.hpp"
#include "nonlinear/nonlinear_problem.hpp"
#include "nonlinear/point_update.hpp"

namespace voussoir {

struct Imbalance {
  double equilibrium;  ///< [N] largest of the residual
  double contact;      ///< [N] largest change the contact law wants
};

/// Largest of a number over the ranks. Collective.
double largest_over_ranks(const NonlinearProblem&, double local);

/// Is any point resolved as contact? Collective.
bool anything_selected(const NonlinearProblem&);

/// Largest force in play [N]: loads and normal contact forces; never zero. Collective.
double force_scale(const NonlinearProblem&, const PointField& lambda);

/// The forces [N] that the contact law makes of lambda at these gaps, judged with the local stiffness: lambda itself
/// where it is met.
void lawful_forces(const NonlinearProblem&, const CurrentLaws&, const PointField& lambda, const PointField& gap,
                   PointField& lawful);

/// Largest change [N] that the contact law wants in the forces lambda at these gaps, judged with the local stiffness.
double contact_residual(const NonlinearProblem&, const CurrentLaws&, const PointField& lambda, const PointField& gap);

/// How far a state with these gaps is from a solution. Collective.
/// @param residual  K x - f, from which the contact forces are taken
Imbalance imbalance(NonlinearProblem&, const CurrentLaws&, const PointField& lambda, const PointField& gap,
                    TpetraVector& residual);

/// The larger of two residuals [N] relative to the largest force; 0 where it is no more than round-off of the sums that
/// make it, since no state is better. Collective.
double size_of(const NonlinearProblem&, double equilibrium, double contact, double scale);

/// A state as a solve is judged: its residuals relative to the largest force, which the report keeps. Returns the size
/// of the two. Collective.
/// @param strength  with its damage where joints soften
/// @param residual  becomes K x - f - B^T lambda
/// @param gap       [m] becomes that of x
double judge_state(NonlinearProblem&, Strength strength, const TpetraVector& x, const PointField& lambda,
                   TpetraVector& residual, PointField& gap, NewtonReport&);

}  // namespace voussoir
