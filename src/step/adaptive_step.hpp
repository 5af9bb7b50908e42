// One load step: the selection loop finds an equilibrium, and what points have gone through is taken over.
#pragma once

#include <memory>

#include "step/selection_loop.hpp"

namespace voussoir {

class AdaptiveStep {
 public:
  explicit AdaptiveStep(const Model&, std::shared_ptr<Progress> = std::make_shared<Progress>());

  /// What happens within its steps.
  const std::shared_ptr<Progress>& progress() const { return progress_; }

  /// State before the first load step: nothing has moved; everything or nothing is selected, as the scene asks.
  ContactState initial_state() const;

  /// One load step, or one time step of the model of one. Collective.
  StepResult take(const ContactState& before, const StepInput&);

  /// Nodal residual K u - f - B^T lambda of each block alone [N]: reactions at held nodes, else zero to tolerance.
  std::vector<double> residual(const ContactState&, const std::vector<double>& load) const;
  /// Motion of a collapse on node copies, largest component 1.
  const std::vector<double>& mechanism() const { return mechanism_; }
  /// Gap and slip of every point [m].
  PointField gaps(const std::vector<double>& displacement) const { return model_.gaps(displacement); }
  /// Of the stones, without the mortar between them.
  PointField stone_gaps(const ContactState& s) const { return model_.gaps(s.displacement, s.lambda); }

 private:
  StepReport find_equilibrium(ContactState&, const StepInput&);

  const Model& model_;
  std::shared_ptr<Progress> progress_;
  SelectionTools tools_;
  std::vector<double> mechanism_;
};

}  // namespace voussoir
