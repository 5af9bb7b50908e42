// Numbers of a load step: rounds of selection, the system they solve, rotations that are followed.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"
#include "nonlinear/active_set_parameters.hpp"
#include "nonlinear/contact_solver_parameters.hpp"

namespace voussoir {

class ParameterSection;

struct StepParameters {
  /// motions of stones as wholes are taken out of the unknowns where round-off of them makes forces
  bool carry = true;
  double error_by_indicator = 5;  ///< times the indicator, the root of decreases, that the error is at most
  double too_large = 2;           ///< times what is allowed beyond which an indicator tells that the error is too large
  /// the same where nothing is selected yet: there errors are one to two times the indicator, so below half of what is
  /// allowed bonding will do; above, to release points costs about as much as to estimate whether it would
  static constexpr double too_large_bonded = 0.5;
  double share_of_a_time_step = 0.5;  ///< of the error tolerance that a time step may have
  double least_noise = 1e-8;          ///< share of the largest force by which forces may be beside their bounds
  /// strain of a foundation that lets the structure move by its size: the proximal weight
  double proximal_strain = 1e-4;
  double next_to_rigid = 1e7;  ///< times the pressure below a column of them from which on stones are next to rigid
  double steepest_softening = 0.25;  ///< of the stiffness a point sees, with which a joint softens at most
  double negligible_turn = 1e-4;     ///< [rad] turn of stones that is followed no further
  /// of the largest violation to which a round is solved that releases points, and of the error tolerance that points
  /// which count as resting may make together: what is wrong beside is worth no more
  static constexpr double share_of_violation = 1 / order_of_magnitude;
  /// tolerance of such a round at most: a violation of more than a tenth of the largest force says no more than that
  static constexpr double coarsest_tolerance = share_of_violation / order_of_magnitude;
  /// tolerance of the first round, whose violations show what to release, and of the linear solve of the estimate, as
  /// of others: with 1e-2 the estimate would depend on ranks by as much
  static constexpr double first_look = ActiveSetParameters{}.accuracy;
  /// times what a release left that the error is then: twice as much as of an indicator, measured 5 to 14 times
  double error_of_remainder() const { return 2 * error_by_indicator; }
  /// linear solves of a round with ties, those of four attempts of active sets: rounds that arrive take up to 81
  static constexpr int solves_with_ties = 4 * ContactSolverParameters{}.fast_solves;
  /// times the tolerance below which violations are noise of the solver
  static constexpr double noise = order_of_magnitude;
  /// times the stiffness of mortar that the local stiffness is at least, and times the stiffness of stones that this
  /// may be at most: W(8) with mortar of 1e12 Pa/m takes 57 solves, 254 without both
  static constexpr double beyond_mortar = order_of_magnitude;
  static constexpr double beyond_stone = order_of_magnitude * order_of_magnitude;
  /// of its strength that a joint has lost beyond what its state asks for: cracks grew in a jump. No less than what an
  /// equilibrium with strength that is held is solved to; no strength is known so well
  static constexpr double jump = ContactSolverParameters{}.held_accuracy;
  /// [-] beyond which errors are all the same, where nothing would be left under load: what is reported is bounded
  static constexpr double largest_error = 100;
  /// of the tolerance that round-off of displacements may make: what a residual does not show
  static constexpr double share_of_round_off = 1 / order_of_magnitude;
  /// of solving and following rotations: those that settle take two to five
  static constexpr int rounds_of_rotations = 30;
  void declare(ParameterSection&);
};

}  // namespace voussoir
