// Numbers of a load step: rounds of selection, the system they solve, rotations that are followed.
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

namespace voussoir {

class ParameterSection;

struct StepParameters {
  /// motions of stones as wholes are taken out of the unknowns where round-off of them makes forces
  bool carry = true;
  double share_of_violation = 0.1;   ///< of the largest violation to which a round is solved that releases points
  double coarsest_tolerance = 1e-2;  ///< of such a round
  double first_look = 1e-4;          ///< tolerance of the first round and of the estimate: they show what to release
  double error_by_indicator = 5;     ///< times the indicator, the root of decreases, that the error is at most
  double error_of_remainder = 10;    ///< times what a release left that the error is then
  double too_large = 2;           ///< times what is allowed beyond which an indicator tells that the error is too large
  double too_large_bonded = 0.8;  ///< the same where nothing is selected yet
  double share_of_a_time_step = 0.5;  ///< of the error tolerance that a time step may have
  int solves_with_ties = 120;         ///< linear solves of a round with ties
  double noise = 10;                  ///< times the tolerance below which violations are noise of the solver
  double least_noise = 1e-8;          ///< share of the largest force by which forces may be beside their bounds
  /// strain of a foundation that lets the structure move by its size: the proximal weight
  double proximal_strain = 1e-4;
  double next_to_rigid = 1e7;  ///< times the pressure below a column of them from which on stones are next to rigid
  double beyond_mortar = 10;   ///< times the stiffness of mortar that the local stiffness is at least
  double beyond_stone = 100;   ///< times the stiffness of stones that this may be at most
  double steepest_softening = 0.25;  ///< of the stiffness a point sees, with which a joint softens at most
  double jump = 1e-3;  ///< of its strength that a joint has lost beyond what its state asks for: cracks grew in a jump
  double negligible_turn = 1e-4;  ///< [rad] turn of stones that is followed no further
  /// [-] beyond which errors are all the same, where nothing would be left under load: what is reported is bounded
  static constexpr double largest_error = 100;
  /// of the tolerance that round-off of displacements may make: what a residual does not show
  static constexpr double share_of_round_off = 0.1;
  /// of solving and following rotations: those that settle take two to five
  static constexpr int rounds_of_rotations = 30;
  void declare(ParameterSection&);
};

}  // namespace voussoir
