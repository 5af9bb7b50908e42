#include "simulation/velocity_update.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/midpoint_rule.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

constexpr double solve_tolerance = 1e-10;

/// Components of points whose relative velocities are to vanish: 1 [points x components].
using Held = std::vector<char>;

/// Points that rest on each other, and these with those that stick: 1 for every component that is held. Forces at a
/// vertex of three blocks are not unique, so a point without one rests there as well when it touches and does not part.
/// @param speed  relative velocities [m/s]
template <int dim>
std::pair<Held, Held> contacts(const Model<dim>& model, const ContactState& state, const PointField& speed,
                               double resting) {
  const auto& points = model.points().points();
  const auto gap = model.gaps(state.displacement);
  const double none = no_force * largest_force(model, state), round_off = closed_gap * model.structure().size();
  const auto loaded = [&](std::size_t k) {
    const bool glued = !state.broken[k] && model.law()[k].tension > 0;
    return state.selected[k] && (state.lambda[dim * k] > none || glued);
  };
  std::vector<char> carries(state.velocity.size() / dim, 0);  // per node
  for (std::size_t k = 0; k < points.size(); ++k)
    if (loaded(k)) carries[points[k].node_i] = carries[points[k].node_j] = 1;
  Held closed(speed.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool between = state.selected[k] && carries[points[k].node_i] && carries[points[k].node_j];
    const bool rests = std::abs(gap[dim * k]) < round_off && std::abs(speed[dim * k]) <= resting;
    closed[dim * k] = loaded(k) || (between && rests);
  }
  auto sticking = closed;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!loaded(k)) continue;
    auto law = model.law()[k];
    if (state.broken[k]) law.cohesion = law.tension = 0;
    double q = 0;
    for (int c = 1; c < dim; ++c) q += state.lambda[dim * k + c] * state.lambda[dim * k + c];
    const bool sticks = std::sqrt(q) < (1 - no_force) * friction_bound(law, state.lambda[dim * k]);
    for (int c = 1; c < dim; ++c) sticking[dim * k + c] = sticks;
  }
  return {closed, sticking};
}

}  // namespace

/// S of the time step with the selection of a step.
template <int dim>
struct VelocityUpdate<dim>::Spread {
  Spread(const Model<dim>& at_rest, const Model<dim>& step_model, const ContactState& s, LinearSolver& solver)
      : state(s),
        zero(s.displacement.size(), 0.0),
        problem({step_model.structure(), at_rest.points(), step_model.continuum(), at_rest.held(),
                 at_rest.local_stiffness(), no_gap, at_rest.scene().preconditioner, solver},
                state, at_rest.law(), zero, zero) {}

  ContactState state;
  std::vector<double> zero, no_gap;
  ContactProblem<dim> problem;
};

template <int dim>
double largest_force(const Model<dim>& model, const ContactState& state) {
  double mine = 0;
  for (int k = 0; k < model.points().owned(); ++k)
    if (state.selected[k]) mine = std::max(mine, state.lambda[dim * k]);
  return largest_over_ranks(*model.structure().comm(), mine);
}

template <int dim>
VelocityUpdate<dim>::VelocityUpdate(const Model<dim>& at_rest, const Structure<dim>& mass)
    : at_rest_(at_rest), mass_(mass), projection_(at_rest, mass), solver_(at_rest.scene().solver) {}

template <int dim>
VelocityUpdate<dim>::~VelocityUpdate() = default;

template <int dim>
void VelocityUpdate<dim>::forget() {
  spread_.reset();
}

template <int dim>
double VelocityUpdate<dim>::product(const std::vector<double>& v, const std::vector<double>& w) const {
  std::vector<double> mw;
  mass_.apply_stiffness(w, mw);
  double mine = 0, all = 0;
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) mine += v[i] * mw[i];
  Teuchos::reduceAll(*mass_.comm(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

/// Largest relative velocity of what is held and can move.
template <int dim>
double VelocityUpdate<dim>::fastest(const PointField& speed, const Held& held) const {
  double mine = 0;
  for (int i = 0; i < dim * at_rest_.points().owned(); ++i)
    if (held[i] && projection_.mass(i / dim, i % dim) > 0) mine = std::max(mine, std::abs(speed[i]));
  return largest_over_ranks(*mass_.comm(), mine);
}

/// What is held, and all of the points that are tied.
template <int dim>
void VelocityUpdate<dim>::project(std::vector<double>& velocity, Held held, const std::vector<char>& selected) {
  for (int i = 0; i < dim * at_rest_.points().size(); ++i)
    held[i] = (held[i] || !selected[i / dim]) && projection_.mass(i / dim, i % dim) > 0;
  projection_.apply(velocity, held);
}

/// How the normal impulses of points that are not at rest spread within a time step.
template <int dim>
std::vector<double> VelocityUpdate<dim>::spread(const PointField& lambda, const PointField& speed,
                                                const Held& closed, double resting) {
  auto& problem = spread_->problem;
  const auto b = Teuchos::rcp(new TpetraVector(problem.map())), d = Teuchos::rcp(new TpetraVector(problem.map()));
  PointField impulse(lambda.size(), 0.0);
  const bool any = fastest(speed, closed) > resting;
  for (std::size_t i = 0; i < closed.size(); i += dim)
    if (closed[i] && (!any || std::abs(speed[i]) > resting)) impulse[i] = -lambda[i];
  problem.subtract_contact_forces(impulse, *b);
  problem.solve(std::vector<PointStiffness>(at_rest_.points().size()), 0.0, b, d, {solve_tolerance});
  std::vector<double> way;
  problem.space().scatter(*d, way);
  return way;
}

template <int dim>
double VelocityUpdate<dim>::apply(const Model<dim>& step, ContactState& state, double lost, double resting) {
  const auto& points = at_rest_.points();
  const auto speed = relative_velocities(points, state.velocity);
  const auto [closed, sticking] = contacts(at_rest_, state, speed, resting);
  auto sliding = sticking;  // only what friction holds
  for (std::size_t i = 0; i < sliding.size(); i += dim) sliding[i] = 0;
  const bool impact = fastest(speed, closed) > resting || lost > 0;
  auto& v = state.velocity;
  if (impact) {
    // A selection that changed on one rank changed for all.
    if (largest_over_ranks(*mass_.comm(), !spread_ || spread_->state.selected != state.selected) > 0)
      spread_ = std::make_unique<Spread>(at_rest_, step, state, solver_);
    const double before = kinetic_energy(v);
    const auto given = v;
    project(v, closed, state.selected);
    const double wanted = lost + before - kinetic_energy(v);
    auto way = spread(state.lambda, speed, closed, resting);
    const double whole = kinetic_energy(way);
    if (whole > 0) {
      auto behind = way;
      project(behind, closed, state.selected);
      // Where closed points hold everything there is no way behind them: then they rebound.
      constexpr double nothing = 1e-12;
      if (kinetic_energy(behind) > nothing * whole) way = behind;
      const double change = least_change(kinetic_energy(way), product(v, way), wanted);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += change * way[i];
    } else {
      v = given;  // the two sides hang together by other ties
    }
  }
  if (fastest(relative_velocities(points, v), sliding) <= resting) return 0;
  const double before = kinetic_energy(v);
  project(v, sticking, state.selected);
  return before - kinetic_energy(v);
}

template <int dim>
std::vector<char> VelocityUpdate<dim>::calm(const ContactState& state, double energy, double resting) const {
  const auto speed = relative_velocities(at_rest_.points(), state.velocity);
  std::vector<char> is_calm(state.selected.size(), 1);
  for (int k = 0; k < at_rest_.points().size(); ++k) {
    double kinetic = 0, fastest = 0;
    for (int c = 0; c < dim; ++c) {
      kinetic += projection_.mass(k, c) * speed[dim * k + c] * speed[dim * k + c] / 2;
      fastest = std::max(fastest, std::abs(speed[dim * k + c]));
    }
    is_calm[k] = fastest <= resting || (at_rest_.law()[k].friction > 0 && kinetic <= energy);
  }
  return is_calm;
}

template <int dim>
double VelocityUpdate<dim>::settle(ContactState& state, double resting) {
  if (!at_rest_.rubs()) return 0;
  const auto speed = relative_velocities(at_rest_.points(), state.velocity);
  const double before = kinetic_energy(state.velocity);
  project(state.velocity, contacts(at_rest_, state, speed, resting).second, state.selected);
  return before - kinetic_energy(state.velocity);
}

template double largest_force<2>(const Model<2>&, const ContactState&);
template class VelocityUpdate<2>;

}  // namespace voussoir
