// What a step is given and what it hands back: a state and an input in, a state and a report out.
//
// A load step and a time step differ in the matrix of the blocks and in the gaps at the start, which their Model has,
// and in the energies that StepInput::in_time names.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "linalg/system_cost.hpp"
#include "model/contact_state.hpp"
#include "nonlinear/newton_report.hpp"

namespace voussoir {

/// What a time step knows beside its load, which holds inertia too.
struct InTime {
  double energy = 0;                    ///< [J] of the structure at its start: what errors are relative to
  const std::vector<double>& own_load;  ///< [N] forces on the stones from outside
};

struct StepInput {
  const std::vector<double>& load;        ///< nodal forces [N, dim x local node copies]
  const std::vector<double>& prescribed;  ///< displacement of held components at the end [m, likewise]
  const InTime* in_time = nullptr;        ///< of a time step; null at rest
};

struct StepReport {
  NewtonReport newton;
  int selection_rounds = 0;
  int estimate_solves = 0;    ///< linear solves for error estimates, besides those of newton
  double error_estimate = 0;  ///< [-] relative, energy norm
  double tied_share = 0;  ///< [-] largest share of a loose stone's load that ties bear, where it could not be released
  int tied_block = -1;    ///< that stone; -1 where no stone is left loose
  std::array<int, 2> unstable_joint{-1, -1};      ///< stones of the joint that softens fastest where newton.unstable
  std::array<int, 2> alike_joint{-1, -1};         ///< stones of the joint that was let crack of newton.alike
  std::array<int, 2> undetermined_joint{-1, -1};  ///< stones of the joint where newton.undetermined is told of
  long long largest_clusters = 0;                 ///< nodes that were unknowns in the last round
  SystemCost cost;
  bool passed_in_time = false;  ///< statics led nowhere: let go with inertia, the structure came to rest there

  bool converged() const { return newton.outcome == NewtonOutcome::converged; }
  /// Goes on with another solution of the same step, which stands.
  void add(const StepReport& again) {
    newton.add(again.newton);
    selection_rounds += again.selection_rounds;
    estimate_solves += again.estimate_solves;
    error_estimate = again.error_estimate;
    tied_share = again.tied_share;
    tied_block = again.tied_block;
    unstable_joint = again.unstable_joint;
    if (again.alike_joint[0] >= 0) alike_joint = again.alike_joint;
    undetermined_joint = again.undetermined_joint;
    largest_clusters = again.largest_clusters;
    cost.add(again.cost);
  }
};

/// On anything but convergence the state is that of the last attempt: its displacement is where a collapse runs away
/// to, and nothing goes on from it. A step that was stopped leaves the state before it.
struct StepResult {
  ContactState after;
  StepReport report;
};

/// Takes a step from a state and puts the state after it in its place. Collective.
template <class Step>
auto advance(Step& step, ContactState& state, const StepInput& input) {
  auto [after, report] = step.take(state, input);
  state = std::move(after);
  return report;
}

}  // namespace voussoir
