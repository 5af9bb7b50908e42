// Numbers of levels of bodies.
#pragma once

namespace voussoir {

struct BodyLevelsParameters {
  /// of the largest diagonal entry, added to all: what is held by nothing is singular, and a direct solution is shifted
  /// by as much (linalg/README.md, "Decisions")
  double shift = 1e-10;
  /// entries a_ij with a_ij^2 below its square times a_ii a_jj do not bring bodies into a group: where joints are open
  /// there are none but by round-off
  double coupled = 1e-6;
  /// smallest eigenvalue of cycle times matrix from which on it will do: conjugate gradients on the matrix alone
  /// would take 20 steps to 1e-8, as many as those after which a system is factored whole
  double least_eigenvalue = 0.2;
  /// the largest is one where the smoother converges; bodies that are loose take round-off to 1e-6
  double largest_eigenvalue = 1 + 1e-3;
  /// steps of Lanczos that measure both: at the smallest that will do they leave a hundredth of an error
  int steps = 5;
  /// unknowns of the coarsest level, which one rank solves directly: their square is as many operations as the level
  /// above has in a sweep, 8.5 times as many rows of 30 entries
  int coarsest = 300;
  /// unknowns of a rank below which a level moves to fewer: twice the coarsest, which no two ranks then share
  int least_of_a_rank = 2 * coarsest;
};

}  // namespace voussoir
