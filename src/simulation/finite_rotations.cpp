#include "simulation/finite_rotations.hpp"

#include "base/text.hpp"

namespace voussoir {
namespace {

// A turn that moves forces by this share of the size of a stone from where they were taken to be [rad]. The next load
// step makes up for it, since it begins where stones stand.
constexpr double negligible_turn = 1e-4;
// Of solving and following. Those that settle take two to five; near a collapse each turns as far as the last.
constexpr int largest_rounds = 30;

}  // namespace

template <int dim>
StepReport solve_load_step(Model<dim>& model, AdaptiveStep<dim>& step, ContactState& state,
                           const std::vector<double>& load, const std::vector<double>& prescribed) {
  if (model.scene().model.rotations == Rotations::small) return step.solve(state, load, prescribed);
  const auto start = state.displacement;
  const auto slip_origin = state.slip_origin;  // one step: slip counts from its start, whatever the rounds were
  model.follow(start);
  StepReport report = step.solve(state, load, prescribed);
  for (int round = 1; report.newton.outcome == NewtonOutcome::converged; ++round) {
    const double turned = model.follow(state.displacement);
    if (turned <= negligible_turn) return report;
    if (round == largest_rounds) {
      report.newton.outcome = NewtonOutcome::not_converged;
      report.newton.reason = "stones turn by " + number_text(turned) + " rad each time they are followed to where they "
                             "have turned to; smaller load steps may find where they stand";
      break;
    }
    state.slip_origin = slip_origin;
    report.add(step.solve(state, load, prescribed));
  }
  model.follow(start);
  return report;
}

template StepReport solve_load_step<2>(Model<2>&, AdaptiveStep<2>&, ContactState&, const std::vector<double>&,
                                       const std::vector<double>&);

}  // namespace voussoir
