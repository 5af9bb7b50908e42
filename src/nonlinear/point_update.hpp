// The augmented contact law over all selected points: trial forces, their projection, their derivative.
#pragma once

#include "nonlinear/nonlinear_problem.hpp"

namespace voussoir {

/// lambda - sigma (g - g_0), the slip measured from its origin.
void trial_forces(const NonlinearProblem&, const PointField& lambda, const PointField& gap, double augmentation,
                  PointField& trial);

/// Largest tangential force of each point under the normal parts of some forces [N].
void friction_bounds(const NonlinearProblem&, const PointField& forces, std::vector<double>& bound);

/// Projection of trial forces on the admissible set with given friction bounds.
void project(const NonlinearProblem&, const PointField& trial, const std::vector<double>& bound, PointField& forces);

/// Which points resist in the next linear system.
void resistances(const NonlinearProblem&, const PointField& trial, const std::vector<double>& bound,
                 double augmentation, std::vector<PointStiffness>&);

}  // namespace voussoir
