// Where stages with a duration begin, what each of their steps is given, and what load steps after them are left.
#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {

double DynamicStep::begin(ContactState& state, bool initial) {
  expect_state(at_rest_, state);
  if (in_motion(*mass_->comm(), state)) return 0;
  auto& v = state.velocity;
  v.assign(state.displacement.size(), 0.0);
  if (initial) v = at_rest_.initial_velocities();
  state.acceleration.clear();
  state.acceleration_before.clear();
  const auto held = at_rest_.held().held_part(v, at_rest_.components());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] -= held[i];
  const auto& points = at_rest_.points();
  for (int k = 0; k < points.size(); ++k)
    if (points.at(k).difference(v) != Vector<3>{}) state.selected[k] = 1;
  const double given = velocities_.kinetic_energy(v);
  if (given == 0) {  // what has stood so far has rested
    const auto gap = at_rest_.gaps(state.displacement);
    state.rest = rested(gap, points.size(), at_rest_.settings().selection.rest);
    bond_what_rests(state, gap, 0.0, 0.0);
    state.rest.bonded.assign(points.size(), 0.0);  // those that soon let go need not rest longer for that
  }
  return given;
}

StepInTime next_in_time(const LoadSteps& steps) {
  VOUSSOIR_EXPECT(!steps.finished() && steps.dynamic() && "the next step is one of time");
  const double begin = steps.reached(), end = steps.target();
  return {steps.time(begin), steps.time(end), steps.factors(begin), steps.factors(end)};
}

void loads_of_time_step(const Model& model, const LoadSteps& steps, std::vector<double>& load,
                        std::vector<double>& prescribed) {
  const auto next = next_in_time(steps);
  std::vector<double> unused;
  model.mean_loads(next, load);
  model.loads(next.end, next.to, unused, prescribed);
}

void untie_what_moved(const Model& model, ContactState& state) {
  const int dim = model.components();
  VOUSSOIR_EXPECT(is_per_point(model, state.selected) && "selected: per point");
  const auto gap = model.gaps(state.displacement);
  for (std::size_t k = 0; k < state.selected.size(); ++k)
    for (int c = 0; c < dim; ++c)
      if (std::abs(gap[dim * k + c]) > closed_gap * model.structure().size()) state.selected[k] = 1;
  state.rest = {};
}

}  // namespace voussoir
