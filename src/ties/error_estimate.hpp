// What it costs that points stay tied: how the structure would move if those that violate their law gave way.
//
// One linear system, of the structure in which every violating point is released and no longer resists where it
// violates, under the forces r by which it does:
//     (K + resistances) e = B^T r,     relative error^2 = e.K e / (u + e).K (u + e)
// This is the first semismooth Newton step of the problem without ties, so blocks that would turn or slide as a whole
// do so. Reasons and numbers: src/selection/README.md.
#pragma once

#include "model/contact_problem.hpp"
#include "model/model.hpp"

namespace voussoir {

/// How far the forces of tied points are from what their law admits.
struct TiedViolations {
  std::vector<double> force;  ///< [N] per owned point; 0 at free points and where it is noise of the solver
  double largest = 0;         ///< [-] over all ranks, relative to the largest normal force
  double largest_normal = 0;  ///< [N] normal force of all points, tied ones too, over all ranks
  double noise = 0;           ///< [N] forces this near to their bounds are at them
};

/// @param state      forces of tied points recovered
/// @param cluster    per local node copy; a point is tied when its nodes have the same cluster
/// Collective.
TiedViolations tied_violations(const Model&, const PointLaws&, const ContactState&, const std::vector<int>& cluster);

/// Energy that releasing each point alone would set free, r^2 / (2 k) [J]: good for telling points apart, not for
/// their sum. k is the stiffness of the cells beside the point [N/m].
std::vector<double> predicted_decrease(const TiedViolations&, const std::vector<double>& local_stiffness);

/// Root of the sum of decreases by the energy of the structure [J]; the error is at most five times that. Collective.
/// @param largest  errors beyond it are all the same
double root_of_decreases(const std::vector<double>& predicted_decrease, double energy, double largest,
                         const Teuchos::Comm<int>&);

/// 1 where a point stands open when a step begins.
std::vector<char> open_points(const Model&);

/// The error of ties, and what it took to know it.
struct TieError {
  std::vector<double> change;  ///< [m] e on local node copies; empty when nothing is violated
  int linear_solves = 0, krylov_iterations = 0;
  bool known = true;  ///< whether the linear solve, where one was needed, arrived
  SystemCost cost;
};

/// @param state     in equilibrium with its ties; ghosts of its forces up to date
/// @param strength  with its damage where joints soften
/// Collective. Costs a linear solve where anything is violated.
TieError tie_error(const ContactProblem::Parts&, const ContactProblem::Asked&, const ContactState& state,
                   const std::vector<int>& cluster, const TiedViolations&, Strength strength = {});

/// Error of ties relative to the energy that the structure would have without them [-]. Collective.
/// @param known_energy  [J] of the structure, where displacement does not tell
/// @param largest       errors beyond it are all the same
double relative_error(const BlockSystem&, const std::vector<double>& displacement, const TieError&, double known_energy,
                      double largest);

/// Largest normal force of all points, tied ones too [N]. Collective.
double largest_normal_force(const Model&, const PointField& lambda);

}  // namespace voussoir
