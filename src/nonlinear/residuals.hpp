// Karush-Kuhn-Tucker residuals of a state: what is out of balance, and what the contact law would change.
#pragma once

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

/// Largest of a number over the ranks. Collective.
double largest_over_ranks(const NonlinearProblem&, double local);

/// Largest force in play [N]: loads and normal contact forces; never zero. Collective.
double force_scale(const NonlinearProblem&, const PointField& lambda);

/// Largest change [N] that the contact law wants in the forces lambda at these gaps, judged with the local stiffness.
double contact_residual(const NonlinearProblem&, const PointField& lambda, const PointField& gap);

}  // namespace voussoir
