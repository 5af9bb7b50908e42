// What steps took, in counts: of those that stand, and of those that failed, were halved or were tried in vain.
#pragma once

#include "model/step.hpp"

namespace voussoir {

struct StepCounts {
  long long selection_rounds = 0;
  long long newton_iterations = 0;
  long long linear_solves = 0;  ///< with those of error estimates
  long long failed_linear_solves = 0;
  long long krylov_iterations = 0;
  long long patch_solves = 0;
  long long factorised = 0, factorised_whole = 0, factors_reused = 0;

  void add(const StepReport& report) {
    const auto& newton = report.newton;
    add({report.selection_rounds, newton.newton_iterations, newton.newton_iterations + report.estimate_solves,
         newton.failed_solves, newton.krylov_iterations, newton.local_solves, report.cost.factorised, report.cost.whole,
         report.cost.reused});
  }
  void add(const StepCounts& more) {
    selection_rounds += more.selection_rounds;
    newton_iterations += more.newton_iterations;
    linear_solves += more.linear_solves;
    failed_linear_solves += more.failed_linear_solves;
    krylov_iterations += more.krylov_iterations;
    patch_solves += more.patch_solves;
    factorised += more.factorised;
    factorised_whole += more.factorised_whole;
    factors_reused += more.factors_reused;
  }
  /// Of a step that was given up, of which nothing else is known.
  void add_solves(int solves) {
    newton_iterations += solves;
    linear_solves += solves;
  }

  /// Names what a checkpoint keeps (output/checkpoint.hpp).
  template <class Archive>
  void keep(Archive& archive) {
    constexpr double largest = 1e15;
    archive.within("in_vain.selection_rounds", selection_rounds, 0, largest);
    archive.within("in_vain.newton_iterations", newton_iterations, 0, largest);
    archive.within("in_vain.linear_solves", linear_solves, 0, largest);
    archive.within("in_vain.failed_linear_solves", failed_linear_solves, 0, largest);
    archive.within("in_vain.krylov_iterations", krylov_iterations, 0, largest);
    archive.within("in_vain.patch_solves", patch_solves, 0, largest);
    archive.within("in_vain.factorised", factorised, 0, largest);
    archive.within("in_vain.factorised_whole", factorised_whole, 0, largest);
    archive.within("in_vain.factors_reused", factors_reused, 0, largest);
  }
};

}  // namespace voussoir
