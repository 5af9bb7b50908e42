// Numbers of the preconditioner: its parts are parameters of a scene (preconditioner_parameters.hpp).
//
// Ranges and reasons: declare() in the .cpp, which voussoir --print-internals shows.
#pragma once

#include "base/order_of_magnitude.hpp"

namespace voussoir {

class ParameterSection;

struct CoarseOperatorParameters {
  int krylov_to_factor = 20;       ///< Krylov iterations after which a system is factored whole, at least
  double bytes_of_factors = 1500;  ///< of a system that is factored whole, per unknown of the most that may be
  double work_per_entry = 100;     ///< operations of factoring that take as long as an iteration, per entry of H
  double largest_region = 0.25;    ///< largest share of all unknowns in regions solved directly, in patches too
  int largest_factor = 300000;     ///< unknowns of the continuum up to which it is factored where stones are uneven
  int motions_on_first = 20000;    ///< block motions up to which the first of several ranks factors them for all
  /// w of the block solves: every contact couples two blocks, so no eigenvalue of S H exceeds 2
  static constexpr double block_weight = 0.5;
  /// layers of cells around nodes that have parted: one to six differ by a tenth of the iterations
  /// (released_region.md)
  static constexpr int layers = 3;
  /// unknowns of the continuum from which on it is preconditioned by multigrid: MueLu stops coarsening at 1000, and
  /// with one level it would be a direct solver on all ranks
  static constexpr int smallest_multigrid = 2000;
  /// change of a resistance up to which factors stay: eigenvalues of S H and Q H move by no more than that
  static constexpr double same = 1 / order_of_magnitude;
  /// ratio of the stiffest stone to the softest up to which multigrid will do: beyond, a factorisation takes a third of
  /// its iterations
  static constexpr double even = order_of_magnitude;
  void declare(ParameterSection&);
};

}  // namespace voussoir
