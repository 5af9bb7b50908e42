// When the static theorem of limit analysis is asked of a run, and what it answers.
//
// It holds for the model as it is computed: the same points with the same laws, where stones turn by small angles. So
// where it refuses loads, the solver would look in vain. It is asked where a load step takes many linear solves or
// fails; and at the end of a stage of few stones that ties hold: the selection lets these bear a little beyond their
// law.
#pragma once

#include <optional>

#include "run/rigid_limits.hpp"
#include "step/finite_rotations.hpp"

namespace voussoir {

/// Whether the theorem says something about a scene, in a time that compares with its solution. The same on all ranks.
bool theorem_applies(const Model<2>&);

/// Loads that no admissible forces balance.
struct Refusal {
  double share = 0;               ///< [-] of the way from the loads before to these that can be borne
  std::vector<double> mechanism;  ///< on local nodes, largest component 1
  bool dilates = false;           ///< what slides in it lifts (statics/coulomb_motion.hpp)
  PointField lambda;              ///< [N] forces at that share
};

/// What the theorem says of one load step at a time.
class StaticTheorem {
 public:
  explicit StaticTheorem(const Model<2>& model) : model_(model), applies_(theorem_applies(model)) {}

  /// A load step begins. What is passed must live as long as the step.
  /// @param ends_stage  whether what it finds will be told as the equilibrium of a stage
  void begin(const std::vector<char>& absent, const ContactState& before, const std::vector<double>& load_before,
             const std::vector<double>& load, bool ends_stage);
  /// Solves it. Where that takes many linear solves, or leads nowhere, the theorem is asked; if it refuses, the step
  /// ends as a collapse in a state that holds forces alone. Collective.
  StepReport solve(AdaptiveStep<2>&, Model<2>&, ContactState&, const std::vector<double>& prescribed);
  /// To be called after each linear solve within solve(). Collective.
  void count_solve();
  /// What the last step came to, if the theorem refused it.
  const std::optional<Refusal>& refusal() const { return refusal_; }

 private:
  bool refuses();
  bool in_doubt(const StepReport&, const ContactState&) const;

  const Model<2>& model_;
  bool applies_, waits_ = false, ends_stage_ = false;
  int solves_ = 0;
  const std::vector<char>* absent_ = nullptr;
  const ContactState* state_ = nullptr;  ///< at the start
  const std::vector<double>*before_ = nullptr, *load_ = nullptr;
  std::optional<Refusal> refusal_;
};

}  // namespace voussoir
