// When the static theorem of limit analysis is asked of a run, and what it answers.
//
// It holds for the model as it is computed: the same points with the same laws, stones that turn by small angles from
// where they stand. So where it refuses loads, the solver would look in vain. It is asked where a load step takes many
// linear solves or fails; and at the end of a stage of few stones that ties hold: the selection lets these bear a
// little beyond their law.
//
// With finite rotations it speaks of stones where they stand, as drawn or where they have been followed to, so it is
// asked at each such place, and of few stones that nothing has moved yet before anything is solved. There it says that
// they move on, not that they rest nowhere else: how far that holds along the mechanism is asked too, and told.
#pragma once

#include <optional>
#include <string>

#include "run/limit_theorem.hpp"
#include "step/finite_rotations.hpp"

namespace voussoir {

/// Whether the theorem can be asked of a model, in a time that compares with its solution. The same on all ranks.
/// @param theorem  none where nothing knows the structure as rigid stones
bool theorem_applies(const Model&, const LimitTheorem* theorem);

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
  StaticTheorem(const Model& model, const LimitTheorem* theorem)
      : model_(model), theorem_(theorem), applies_(theorem_applies(model, theorem)) {}

  /// A load step begins. What is passed must live as long as the step.
  /// @param ends_stage  whether what it finds will be told as the equilibrium of a stage
  void begin(const std::vector<char>& absent, const ContactState& before, const std::vector<double>& load_before,
             const std::vector<double>& load, bool ends_stage);
  /// Solves it. Where that takes many linear solves, or leads nowhere, the theorem is asked; if it refuses, the step
  /// ends as a collapse in a state that holds forces alone. Collective.
  StepReport solve(AdaptiveStep&, Model&, ContactState&, const std::vector<double>& prescribed);
  /// To be asked after each linear solve: counts those within solve(), and when they are many asks the theorem, which
  /// takes about as long as they did. Collective.
  GoOn after_solve();
  /// What the last step came to, if the theorem refused it.
  const std::optional<Refusal>& refusal() const { return refusal_; }
  /// Whether it has refused the last step so that parts of it gain nothing: with small rotations its end is
  /// refused by any way, with finite ones where nothing of it can be borne.
  bool refuses_any_part() const;
  /// Whether the last step was solved, or refused, with stones where they stood at its start.
  bool at_the_start() const { return places_ <= 1; }

 private:
  bool refuses();
  bool in_doubt(const StepReport&, const ContactState&) const;
  bool nothing_has_moved() const;
  std::string along_the_mechanism(Model&, const ContactState& from) const;
  std::string reason(Model&, const ContactState& from) const;

  const Model& model_;
  const LimitTheorem* theorem_;
  bool applies_, asked_ = false, ends_stage_ = false;
  bool solving_ = false;  ///< within a step that was begun
  int arrangement_ = -1;  ///< of the place where solves are counted
  int places_ = 0;        ///< where stones have stood within this step
  int solves_ = 0, solves_here_ = 0;
  const std::vector<char>* absent_ = nullptr;
  const ContactState* state_ = nullptr;  ///< at the start
  const std::vector<double>*before_ = nullptr, *load_ = nullptr;
  std::optional<Refusal> refusal_;
};

}  // namespace voussoir
