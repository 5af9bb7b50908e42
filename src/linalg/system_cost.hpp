// What the systems of a load step took besides their solution: factorisations and memory, in counts.
#pragma once

#include <algorithm>

namespace voussoir {

struct SystemCost {
  int factorised = 0;      ///< linear solves whose preconditioner was factored for them
  int whole = 0;           ///< systems that were factored whole
  int levels = 0;          ///< block motions in place of whose factors there are levels
  int levels_refused = 0;  ///< whose levels did not converge: they were factored
  int reused = 0;          ///< linear solves that took the factors of the solve before, of the step before too
  /// Largest of all selections, this rank [byte].
  long long matrix_bytes = 0, block_bytes = 0, motion_bytes = 0, whole_bytes = 0;

  void add(const SystemCost& other) {
    factorised += other.factorised;
    whole += other.whole;
    levels += other.levels;
    levels_refused += other.levels_refused;
    reused += other.reused;
    matrix_bytes = std::max(matrix_bytes, other.matrix_bytes);
    block_bytes = std::max(block_bytes, other.block_bytes);
    motion_bytes = std::max(motion_bytes, other.motion_bytes);
    whole_bytes = std::max(whole_bytes, other.whole_bytes);
  }
};

}  // namespace voussoir
