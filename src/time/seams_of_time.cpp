// Where stages with a duration begin, what each of their steps is given, and what load steps after them are left.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "blocks/assembly.hpp"
#include "linalg/reduce.hpp"
#include "model/handed_over.hpp"
#include "model/scene_fit.hpp"
#include "time/dynamic_step.hpp"

namespace voussoir {
namespace {

/// The place about which a set of blocks turns when time begins [m]: given, or its mass centre. Collective.
template <int dim>
Vector<dim> centre_of_rotation(const Model<dim>& model, const InitialVelocityParameters& given) {
  const auto& s = model.structure();
  Vector<dim> centre{given.about_x, given.about_y};
  if (given.rotation == 0) return s.middle();
  std::array<double, dim + 1> mine{};  // mass, and its moments about the middle of the structure
  for (int n = 0; n < s.owned_blocks(); ++n) {
    const auto& b = s.blocks()[n];
    if (!in_set(model.source(), b.mesh, given.blocks)) continue;
    const auto volume = nodal_volumes(b.mesh, s.model().thickness);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      const double mass = b.material.density * volume[i];
      mine[dim] += mass;
      for (int c = 0; c < dim; ++c) mine[c] += mass * (b.mesh.position[i][c] - s.middle()[c]);
    }
  }
  const auto all = total_of_each(*s.comm(), mine);
  for (int c = 0; c < dim; ++c)
    if (std::isinf(centre[c])) centre[c] = s.middle()[c] + all[c] / all[dim];
  return centre;
}

}  // namespace

template <int dim>
double DynamicStep<dim>::begin(ContactState& state, bool initial) {
  expect_state(at_rest_, state);
  if (in_motion(*mass_.comm(), state)) return 0;
  const auto& s = at_rest_.structure();
  auto& v = state.velocity;
  v.assign(state.displacement.size(), 0.0);
  state.acceleration.clear();
  state.acceleration_before.clear();
  for (const auto& [name, given] : at_rest_.settings().velocities) {
    if (!initial) break;
    const auto centre = centre_of_rotation(at_rest_, given);
    for (const auto& b : s.blocks()) {
      if (!in_set(at_rest_.source(), b.mesh, given.blocks)) continue;
      for (std::size_t i = 0; i < b.mesh.position.size(); ++i) {
        const auto arm = b.mesh.position[i] - centre;
        v[dim * (b.first_local + i)] = given.vx - given.rotation * arm[1];
        v[dim * (b.first_local + i) + 1] = given.vy + given.rotation * arm[0];
      }
    }
  }
  for (std::size_t i = 0; i < v.size(); ++i)
    if (at_rest_.held()[i]) v[i] = 0;
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

template <int dim>
void loads_of_time_step(const Model<dim>& model, const LoadSteps& steps, std::vector<double>& load,
                        std::vector<double>& prescribed) {
  VOUSSOIR_EXPECT(!steps.finished() && steps.dynamic() && "the next step is one of time");
  const double begin = steps.reached(), end = steps.target();
  std::vector<double> unused;
  model.mean_loads({steps.time(begin), steps.time(end), steps.factors(begin), steps.factors(end)}, load);
  model.loads(steps.factors(end), steps.time(end), unused, prescribed);
}

template <int dim>
void untie_what_moved(const Model<dim>& model, ContactState& state) {
  VOUSSOIR_EXPECT(is_per_point(model, state.selected) && "selected: per point");
  const auto gap = model.gaps(state.displacement);
  for (std::size_t k = 0; k < state.selected.size(); ++k)
    for (int c = 0; c < dim; ++c)
      if (std::abs(gap[dim * k + c]) > closed_gap * model.structure().size()) state.selected[k] = 1;
  state.rest = {};
}

template void loads_of_time_step<2>(const Model<2>&, const LoadSteps&, std::vector<double>&, std::vector<double>&);
template void untie_what_moved<2>(const Model<2>&, ContactState&);
template double DynamicStep<2>::begin(ContactState&, bool);

}  // namespace voussoir
