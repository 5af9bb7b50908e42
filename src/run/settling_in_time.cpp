#include "run/settling_in_time.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/components.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "run/settling_parameters.hpp"
#include "step/finite_rotations.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {
namespace {

constexpr double pi = 3.14159265358979323846;
using SettlingNumbers = SettlingParameters;

/// Total of the sizes of nodal loads [N].
double size_of(const BlockSystem& s, const std::vector<double>& load) {
  double sum = 0;
  const int dim = s.components();
  for (int n = 0; n < s.owned_nodes(); ++n) sum += length_of(&load[dim * n], dim);
  return total_over_ranks(*s.comm(), sum);
}

double largest_motion(const BlockSystem& s, const std::vector<double>& a, const std::vector<double>* b = nullptr) {
  const int dim = s.components();
  double largest = 0;
  for (int n = 0; n < s.owned_nodes(); ++n) {
    Vector<3> motion{};
    for (int c = 0; c < dim; ++c) motion[c] = a[dim * n + c] - (b ? (*b)[dim * n + c] : 0.0);
    largest = std::max(largest, length_of(motion.data(), dim));
  }
  return largest_over_ranks(*s.comm(), largest);
}

/// A load step from where the structure has come to rest. Says whether that is an equilibrium, or all is given up.
bool confirm(Model& model, AdaptiveStep& step, const LoadIncrement& increment, int most_solves, Settled& settled) {
  auto state = settled.state;
  untie_what_moved(model, state);
  state.velocity.clear();
  const SolveBudget budget(step, std::min(SettlingNumbers::solves_to_confirm, most_solves));
  const auto report = solve_load_step(model, step, state, increment.load, increment.prescribed);
  settled.stopped = report.newton.stopped && !budget.spent();
  if (budget.spent()) {
    settled.solves += budget.solves();
    settled.counts.newton_iterations += budget.solves();
    settled.counts.linear_solves += budget.solves();
  }
  if (report.newton.stopped) return settled.stopped;
  settled.report = report;
  settled.solves += budget.solves();
  if (settled.report.newton.outcome != NewtonOutcome::converged) {
    settled.counts.add_work(numbers_of(settled.report));
    return false;
  }
  settled.state = state;
  settled.verdict = Verdict::equilibrium;
  return true;
}

/// One step of the motion; without an equilibrium where it was given up.
TimeStepReport take_step(DynamicStep& dynamics, ContactState& state, const StepInput& input, int most_solves,
                         Settled& settled) {
  const SolveBudget budget(dynamics, most_solves - settled.solves);
  auto report = advance(dynamics, state, input);
  settled.stopped = report.step.newton.stopped && !budget.spent();
  if (report.step.newton.stopped) {
    report = {};
    report.step.newton.newton_iterations = budget.solves();
  }
  settled.solves += budget.solves();
  settled.counts.add_work(numbers_of(report.step));
  return report;
}

}  // namespace

bool can_settle_in_time(const Model& model) {
  double lightest = INFINITY;
  for (int b = 0; b < model.structure().local_blocks(); ++b)
    lightest = std::min(lightest, model.structure().nodes_of(b).material.density);
  const bool heavy = largest_over_ranks(*model.structure().comm(), -lightest) < 0;
  return heavy && model.settings().rotations == Rotations::small &&
         model.settings().selection.mode != SelectionMode::bonded;
}

Settled settle_in_time(Model& model, AdaptiveStep& step, const ContactState& equilibrium,
                       const LoadIncrement& increment, int most_solves) {
  expect_state(model, equilibrium);
  VOUSSOIR_EXPECT(is_of_nodes(model, increment.load_before) && is_of_nodes(model, increment.load) &&
                  "loads: of node copies");
  VOUSSOIR_EXPECT(is_of_nodes(model, increment.prescribed) && "prescribed displacement: of node copies");
  const auto& s = model.structure();
  Settled settled;
  settled.state = equilibrium;
  settled.state.velocity.clear();
  auto& state = settled.state;
  DynamicStep dynamics(model, step.progress());
  const double crossing = dynamics.crossing_time(), period = SettlingNumbers::passages_in_period * crossing;
  dynamics.set_stiffness_damping(period / pi);  // critical at that period
  dynamics.begin(state, false);
  const double acceleration = size_of(s, increment.load) / dynamics.total_mass();
  const double deforms = acceleration * std::pow(period / (2 * pi), 2);
  double time_step = period / SettlingNumbers::steps_in_period, energy_before = 0,
         rests_below = SettlingNumbers::near_rest;
  int grown = 0;
  for (int length = 0; length < SettlingNumbers::lengths; ++length, time_step *= 2) {
    dynamics.set_time_step(time_step);
    double elastic = 0, kinetic = 0;
    const auto before = state.displacement;
    for (int k = 0; k < SettlingNumbers::steps_of_a_length; ++k) {
      const double share = length > 0 ? 1.0 : (k + 0.5) / SettlingNumbers::steps_of_a_length;
      auto load = increment.load_before;
      for (std::size_t i = 0; i < load.size(); ++i) load[i] += share * (increment.load[i] - load[i]);
      // Supports move evenly: after an even number of steps the midpoint rule leaves them at rest.
      const double moved = length > 0 ? 1.0 : (k + 1.0) / SettlingNumbers::steps_of_a_length;
      auto held = equilibrium.displacement;
      for (std::size_t i = 0; i < held.size(); ++i) held[i] += moved * (increment.prescribed[i] - held[i]);
      const auto report = take_step(dynamics, state, {load, held}, most_solves, settled);
      if (report.step.newton.outcome != NewtonOutcome::converged) return settled;
      settled.time += time_step;
      elastic = report.elastic, kinetic = report.kinetic;
    }
    grown = kinetic > SettlingNumbers::growth * energy_before && length > 0 ? grown + 1 : 0;
    energy_before = kinetic;
    const bool moves_on = grown >= SettlingNumbers::lengths_of_growth;
    if (moves_on && largest_motion(s, state.displacement, &equilibrium.displacement) > SettlingNumbers::far * deforms) {
      settled.verdict = Verdict::collapse;
      // Not the velocity, in which stiff vibrations ring on that steps of this length do not resolve.
      settled.mechanism = state.displacement;
      const double largest = largest_motion(s, state.displacement, &before);
      for (std::size_t i = 0; i < before.size(); ++i)
        settled.mechanism[i] = (state.displacement[i] - before[i]) / largest;
      return settled;
    }
    if (length == 0 || kinetic > rests_below * elastic) continue;
    if (confirm(model, step, increment, most_solves - settled.solves, settled)) return settled;
    rests_below = SettlingNumbers::calmer * kinetic / elastic;
  }
  return settled;
}

}  // namespace voussoir
