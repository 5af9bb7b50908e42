#include "time/velocity_update.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "dynamics/midpoint_rule.hpp"
#include "joints/tractions.hpp"
#include "linalg/reduce.hpp"
#include "linalg/solver_failure.hpp"
#include "model/handed_over.hpp"
#include "model/joint_strength.hpp"
#include "model/mortar.hpp"
#include "time/free_bodies.hpp"

namespace voussoir {
namespace {

/// Components of points whose relative velocities are to vanish: 1 [points x components].
using Marks = std::vector<char>;

/// Which points bear something: per point.
std::vector<char> loaded_points(const Model& model, const ContactState& state) {
  const int dim = model.components();
  const double none = model.settings().internals.step.least_noise * largest_force(model, state);
  std::vector<char> loaded(state.selected.size());
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    const bool whole = state.opened.empty() || state.opened[k] == 0;
    const bool glued = whole && law_left(model, state, static_cast<int>(k)).tension > 0;
    loaded[k] = state.selected[k] && (state.lambda[dim * k] > none || glued);
  }
  return loaded;
}

/// Points that rest on each other: 1 for their normal components. Forces at a vertex of three blocks are not unique, so
/// a point without one rests there as well when it touches and does not part.
/// @param speed  relative velocities [m/s]
Marks closed_points(const Model& model, const ContactState& state, const std::vector<char>& loaded,
                    const PointField& speed, double resting) {
  const int dim = model.components();
  const auto& points = model.points();
  const auto gap = model.gaps(state.displacement);
  const double round_off = closed_gap * model.structure().size();
  std::vector<char> carries(state.velocity.size() / dim, 0);  // per node
  for (int k = 0; k < points.size(); ++k)
    if (loaded[k]) points.at(k).each([&](int node, double) { carries[node] = 1; });
  Marks closed(speed.size(), 0);
  for (int k = 0; k < points.size(); ++k) {
    const bool between = state.selected[k] && points.at(k).all([&](int node) { return carries[node] != 0; });
    const bool rests = std::abs(gap[dim * k]) < round_off && std::abs(speed[dim * k]) <= resting;
    closed[dim * k] = (loaded[k] || (between && rests)) && !yields(model, k);  // springs stop nothing
  }
  return closed;
}

/// Whether friction holds a point that bears something, with a margin for what the solver leaves.
bool sticks(const Model& model, const ContactState& state, std::size_t k) {
  const int dim = model.components();
  const auto law = law_left(model, state, static_cast<int>(k));
  double q = 0;
  for (int c = 1; c < dim; ++c) q += state.lambda[dim * k + c] * state.lambda[dim * k + c];
  const double margin = model.settings().internals.step.least_noise;
  return std::sqrt(q) < (1 - margin) * friction_bound(law, state.lambda[dim * k]);
}

/// Points that rest on each other, and these with those that stick: 1 for every component that is held.
std::pair<Marks, Marks> contacts(const Model& model, const ContactState& state, const PointField& speed,
                                 double resting) {
  const int dim = model.components();
  const auto loaded = loaded_points(model, state);
  const auto closed = closed_points(model, state, loaded, speed, resting);
  auto sticking = closed;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    for (int c = 1; c < dim && loaded[k]; ++c)
      sticking[dim * k + c] = !yields(model, static_cast<int>(k), c) && sticks(model, state, k);
  return {closed, sticking};
}

}  // namespace

/// S of the time step with the selection of a step.
struct VelocityUpdate::Spread {
  Spread(const Model& at_rest, const BlockSystem& mass, const Model& step_model, const ContactState& s,
         LinearSolver& solver)
      : state(s),
        zero(s.displacement.size(), 0.0),
        problem({step_model.structure(), at_rest.points(), step_model.continuum(), at_rest.held(),
                 at_rest.local_stiffness(), no_gap, at_rest.settings().preconditioner, at_rest.settings().internals,
                 solver},
                state.selected, {at_rest.law(), state.slip_origin, zero, zero}),
        bodies(at_rest, mass, state.selected) {}

  ContactState state;
  std::vector<double> zero, no_gap;
  ContactProblem problem;
  FreeBodies bodies;
};

double largest_force(const Model& model, const ContactState& state) {
  const int dim = model.components();
  VOUSSOIR_EXPECT(is_of_points(model, state.lambda) && "lambda: of points");
  double mine = 0;
  for (int k = 0; k < model.points().owned(); ++k)
    if (state.selected[k]) mine = std::max(mine, state.lambda[dim * k]);
  return largest_over_ranks(*model.structure().comm(), mine);
}

VelocityUpdate::VelocityUpdate(const Model& at_rest, const BlockSystem& mass)
    : at_rest_(at_rest), mass_(mass), projection_(at_rest, mass), solver_(at_rest.settings().solver) {}

VelocityUpdate::~VelocityUpdate() = default;

void VelocityUpdate::forget() { spread_.reset(); }

double VelocityUpdate::product(const std::vector<double>& v, const std::vector<double>& w) const {
  const int dim = at_rest_.components();
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, v) && is_of_nodes(at_rest_, w) && "velocities: of node copies");
  std::vector<double> mw;
  mass_.apply_stiffness(w, mw);
  double mine = 0;
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) mine += v[i] * mw[i];
  return total_over_ranks(*mass_.comm(), mine);
}

/// Largest relative velocity of what is held and can move.
double VelocityUpdate::fastest(const PointField& speed, const Marks& held) const {
  const int dim = at_rest_.components();
  double mine = 0;
  for (int i = 0; i < dim * at_rest_.points().owned(); ++i)
    if (held[i] && projection_.mass(i / dim, i % dim) > 0) mine = std::max(mine, std::abs(speed[i]));
  return largest_over_ranks(*mass_.comm(), mine);
}

VelocityUpdate::Supports VelocityUpdate::moving_supports(const std::vector<double>& velocity) const {
  bool mine = false;
  for (const double v : at_rest_.held().held_part(velocity, at_rest_.components())) mine |= v != 0;
  return any_of_ranks(*mass_.comm(), mine) ? std::make_unique<const std::vector<double>>(velocity) : nullptr;
}

/// What is held, and all of the points that are tied. Returns the work of supports.
double VelocityUpdate::project(std::vector<double>& velocity, Marks held, const std::vector<char>& selected,
                               const Supports& supports) {
  const int dim = at_rest_.components();
  for (int i = 0; i < dim * at_rest_.points().size(); ++i)
    held[i] = (held[i] || !selected[i / dim]) && projection_.mass(i / dim, i % dim) > 0;
  return projection_.apply(velocity, held, supports.get());
}

/// The same, as friction does it. Seen from supports the velocities that are left have no part in the ones that were
/// taken, so the loss is the energy of these: a square, which round-off cannot make a gain.
EnergyOfJump VelocityUpdate::stop(std::vector<double>& velocity, const Marks& held, const std::vector<char>& selected,
                                  const Supports& supports) {
  auto taken = velocity;
  EnergyOfJump energy;
  energy.work_of_supports = project(velocity, held, selected, supports);
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] -= velocity[i];
  energy.friction = kinetic_energy(taken);
  return energy;
}

/// How the normal impulses of points that are not at rest spread within a time step.
VelocityUpdate::Way VelocityUpdate::spread(const Model& step, const PointField& lambda, const PointField& speed,
                                           const Marks& closed, double resting, const Supports& supports) {
  const int dim = at_rest_.components();
  auto& problem = spread_->problem;
  const auto b = Teuchos::rcp(new TpetraVector(problem.map())), d = Teuchos::rcp(new TpetraVector(problem.map()));
  PointField impulse(lambda.size(), 0.0);
  const bool any = fastest(speed, closed) > resting;
  for (std::size_t i = 0; i < closed.size(); i += dim)
    if (closed[i] && (!any || std::abs(speed[i]) > resting)) impulse[i] = -lambda[i];
  problem.subtract_contact_forces(impulse, *b);
  const auto solved = problem.solve(std::vector<PointStiffness>(at_rest_.points().size()), 0.0, b, d,
                                    {at_rest_.settings().internals.time_step.velocity_accuracy});
  if (!solved.converged) throw SolverFailure("how impulses spread is not found: " + solved.failure);
  Way way;
  const auto& space = problem.space();
  space.scatter(*d, way.velocity);
  if (!supports) return way;
  // Supports hold back S d - B^T lambda. The part of S d that is not inertia does no work on a motion as a whole.
  std::vector<double> impulses;
  step.structure().apply_stiffness(way.velocity, impulses);
  add_contact_forces(at_rest_.points(), space.cluster(), impulse, 1.0, impulses);
  const auto moved = space.held_part(*supports);
  double work = 0;
  for (int i = 0; i < dim * mass_.owned_nodes(); ++i) work += impulses[i] * moved[i];
  way.work_of_supports = total_over_ranks(*mass_.comm(), work) / step.inertia();
  return way;
}

/// A way without the motions of free bodies as wholes. Seen from supports that move alike these had no work of theirs.
VelocityUpdate::Way VelocityUpdate::within_bodies(Way way, const Supports& supports) const {
  const int dim = at_rest_.components();
  const auto momentum = spread_->bodies.remove_motion(way.velocity);
  if (!supports) return way;
  const auto moved = at_rest_.held().held_part(*supports, dim);
  std::array<double, 4> mine{};  // velocities of what is held, and how many nodes are
  for (int n = 0; n < mass_.owned_nodes(); ++n) {
    bool holds = false;
    for (int c = 0; c < dim; ++c) holds = holds || at_rest_.held()[dim * n + c];
    if (!holds) continue;
    mine[dim] += 1;
    for (int c = 0; c < dim; ++c) mine[c] += moved[dim * n + c];
  }
  const auto all = total_of_each(*mass_.comm(), mine);
  for (int c = 0; c < dim; ++c) way.work_of_supports -= momentum[c] * all[c] / all[dim];
  return way;
}

EnergyOfJump VelocityUpdate::apply(const Model& step, ContactState& state, double lost, double resting) {
  const int dim = at_rest_.components();
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, state.velocity) && "velocity: of node copies");
  VOUSSOIR_EXPECT(std::isfinite(lost) && lost >= 0 && "energy of closing: not negative");
  VOUSSOIR_EXPECT(resting >= 0 && "resting speed: not negative");
  const auto& points = at_rest_.points();
  const auto speed = relative_velocities(points, state.velocity);
  const auto [closed, sticking] = contacts(at_rest_, state, speed, resting);
  auto sliding = sticking;  // only what friction holds
  for (std::size_t i = 0; i < sliding.size(); i += dim) sliding[i] = 0;
  const bool impact = fastest(speed, closed) > resting || lost > 0;
  const auto supports = moving_supports(state.velocity);
  auto& v = state.velocity;
  EnergyOfJump energy;
  if (impact) {
    // A selection that changed on one rank changed for all.
    if (any_of_ranks(*mass_.comm(), !spread_ || spread_->state.selected != state.selected))
      spread_ = std::make_unique<Spread>(at_rest_, mass_, step, state, solver_);
    const double before = kinetic_energy(v);
    const auto given = v;
    const double work = project(v, closed, state.selected, supports);
    const double wanted = lost + before - kinetic_energy(v) + work;
    auto way = spread(step, state.lambda, speed, closed, resting, supports);
    const double whole = kinetic_energy(way.velocity);
    if (whole > 0) {
      // Where closed points hold everything there is no way behind them: then they rebound.
      auto behind = within_bodies(way, supports);
      behind.work_of_supports += project(behind.velocity, closed, state.selected, supports);
      if (kinetic_energy(behind.velocity) > at_rest_.settings().internals.time_step.no_way * whole) way = behind;
      const double slope = product(v, way.velocity) - way.work_of_supports;
      const double change = least_change(kinetic_energy(way.velocity), slope, wanted);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += change * way.velocity[i];
      energy.work_of_supports = work + change * way.work_of_supports;
    } else {
      v = given;  // the two sides hang together by other ties
    }
  }
  if (fastest(relative_velocities(points, v), sliding) <= resting) return energy;
  const auto stopped = stop(v, sticking, state.selected, supports);
  energy.friction = stopped.friction;
  energy.work_of_supports += stopped.work_of_supports;
  return energy;
}

std::vector<char> VelocityUpdate::calm(const ContactState& state, double energy, double resting) const {
  const int dim = at_rest_.components();
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, state.velocity) && "velocity: of node copies");
  VOUSSOIR_EXPECT(resting >= 0 && "resting speed: not negative");
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

EnergyOfJump VelocityUpdate::settle(ContactState& state, double resting) {
  if (!at_rest_.rubs()) return {};
  const auto speed = relative_velocities(at_rest_.points(), state.velocity);
  return stop(state.velocity, contacts(at_rest_, state, speed, resting).second, state.selected,
              moving_supports(state.velocity));
}

}  // namespace voussoir
