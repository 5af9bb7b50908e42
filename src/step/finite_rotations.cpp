#include "step/finite_rotations.hpp"

#include "base/check.hpp"
#include "base/text.hpp"

namespace voussoir {

StepReport solve_load_step(Model& model, AdaptiveStep& step, ContactState& state, const std::vector<double>& load,
                           const std::vector<double>& prescribed) {
  VOUSSOIR_EXPECT(load.size() == state.displacement.size() && "load: of node copies");
  VOUSSOIR_EXPECT(prescribed.size() == state.displacement.size() && "prescribed displacement: of node copies");
  if (model.settings().rotations == Rotations::small) return advance(step, state, {load, prescribed});
  const auto& numbers = model.settings().internals.step;
  const auto start = state.displacement;
  const auto opened = state.opened, slipped = state.slipped;
  const auto slip_origin = state.slip_origin;  // one step: slip counts from its start, whatever the rounds were
  model.move_geometry(start);
  StepReport report = advance(step, state, {load, prescribed});
  for (int round = 1; report.converged(); ++round) {
    const double turned = model.move_geometry(state.displacement);
    if (turned <= numbers.negligible_turn) return report;
    if (round == numbers.rounds_of_rotations) {
      report.newton.outcome = NewtonOutcome::not_converged;
      report.newton.reason = "stones turn by " + three_digits(turned) +
                             " rad each time they are followed to where they "
                             "have turned to; smaller load steps may find where they stand";
      break;
    }
    state.slip_origin = slip_origin;
    state.opened = opened;
    state.slipped = slipped;
    report.add(advance(step, state, {load, prescribed}));
  }
  model.move_geometry(start);
  return report;
}

}  // namespace voussoir
