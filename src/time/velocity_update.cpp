#include "time/velocity_update.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
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

/// Whether the stones of a point that a load step calls selected hang together all the same, as a tie would hold them:
/// by strength that nothing has used up and that bears what there is, in every direction.
bool hangs_together(const Model& model, const ContactState& state, int k) {
  const auto law = law_left(model, state, k);
  const bool can_be_one = model.joined(k) && (model.never_tied().empty() || model.never_tied()[k] == 0);
  const bool gives_way = yields(model, k) || yields(model, k, 1);
  const bool whole = state.opened.empty() || (state.opened[k] == 0 && state.slipped[k] == 0);
  return can_be_one && !gives_way && whole && law.tension > 0 && law.cohesion > 0 && sticks(model, state, k);
}

/// Which points a jump of velocities treats how.
struct Contacts {
  Marks closed;             ///< 1 for what rests on each other: normal components
  Marks sticking;           ///< these, and components along the joint of points that stick
  std::vector<char> apart;  ///< per point: 1 where neither a tie nor strength makes two stones one
};

Contacts contacts(const Model& model, const ContactState& state, const PointField& speed, double resting) {
  const int dim = model.components();
  const auto loaded = loaded_points(model, state);
  Contacts c;
  c.closed = closed_points(model, state, loaded, speed, resting);
  c.sticking = c.closed;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    for (int a = 1; a < dim && loaded[k]; ++a)
      c.sticking[dim * k + a] = !yields(model, static_cast<int>(k), a) && sticks(model, state, k);
  c.apart = state.selected;
  for (std::size_t k = 0; k < loaded.size(); ++k)
    if (c.apart[k] && hangs_together(model, state, static_cast<int>(k))) c.apart[k] = c.closed[dim * k] = 0;
  return c;
}

}  // namespace

/// S of the time step with the selection of a step.
struct VelocityUpdate::Spread {
  Spread(const Model& at_rest, const BlockSystem& mass, const Model& step_model, const ContactState& state,
         std::vector<char> points_apart, LinearSolver& solver)
      : apart(std::move(points_apart)),
        slip_origin(state.slip_origin),
        zero(state.displacement.size(), 0.0),
        problem({step_model.structure(), at_rest.points(), step_model.continuum(), at_rest.held(),
                 at_rest.local_stiffness(), no_gap, at_rest.settings().preconditioner, at_rest.settings().internals,
                 solver},
                apart, {at_rest.law(), slip_origin, zero, zero}),
        bodies(at_rest, mass, apart) {}

  std::vector<char> apart;
  PointField slip_origin;
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

void add_impulses(std::vector<double>& sum, const std::vector<double>& more, double factor) {
  if (sum.size() < more.size()) sum.resize(more.size(), 0.0);
  for (std::size_t i = 0; i < more.size(); ++i) sum[i] += factor * more[i];
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
  auto moved = at_rest_.held().held_part(velocity, at_rest_.components());
  const bool mine = std::any_of(moved.begin(), moved.end(), [](double v) { return v != 0; });
  return any_of_ranks(*mass_.comm(), mine) ? std::make_unique<const std::vector<double>>(std::move(moved)) : nullptr;
}

double VelocityUpdate::work(const std::vector<double>& impulses, const Supports& supports) const {
  if (!supports) return 0;
  const auto owned = static_cast<std::size_t>(at_rest_.components()) * mass_.owned_nodes();
  double mine = 0;
  for (std::size_t i = 0; i < std::min(owned, impulses.size()); ++i) mine += impulses[i] * (*supports)[i];
  return total_over_ranks(*mass_.comm(), mine);
}

double VelocityUpdate::work_of_supports(const std::vector<double>& impulses,
                                        const std::vector<double>& velocity) const {
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, velocity) && "velocity: of node copies");
  VOUSSOIR_EXPECT((impulses.empty() || is_of_nodes(at_rest_, impulses)) && "impulses: of node copies, or none");
  return work(impulses, moving_supports(velocity));
}

/// What is held, and all of the points where stones are one.
JumpImpulses VelocityUpdate::project(std::vector<double>& velocity, Marks held, const std::vector<char>& apart) {
  const int dim = at_rest_.components();
  for (int i = 0; i < dim * at_rest_.points().size(); ++i)
    held[i] = (held[i] || !apart[i / dim]) && projection_.mass(i / dim, i % dim) > 0;
  return projection_.apply(velocity, held);
}

/// The same, as friction does it. Seen from supports the velocities that are left have no part in the ones that were
/// taken, so the loss is the energy of these: a square, which round-off cannot make a gain.
VelocityJump VelocityUpdate::stop(std::vector<double>& velocity, const Marks& held, const std::vector<char>& apart) {
  auto taken = velocity;
  VelocityJump jump;
  jump.impulses = project(velocity, held, apart).of_supports;
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] -= velocity[i];
  jump.friction = kinetic_energy(taken);
  return jump;
}

/// How the normal impulses of points that are not at rest spread within a time step.
VelocityUpdate::Way VelocityUpdate::spread(const Model& step, const PointField& lambda, const PointField& speed,
                                           const Marks& closed, double resting) {
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
  // Of every block, M dv is what joints, ties and supports give it, but for what deforms it, which has no resultant.
  step.structure().apply_stiffness(way.velocity, way.impulses);
  for (double& p : impulse) p = -p;
  recover_tied_forces(at_rest_.points(), space.cluster(), at_rest_.held(), way.impulses, impulse);
  at_rest_.points().exchange().update(impulse, dim);
  add_contact_forces(at_rest_.points(), {}, impulse, -1.0, way.impulses);
  for (double& p : way.impulses) p /= step.inertia();
  for (double& p : impulse) p /= step.inertia();
  way.at_points = std::move(impulse);
  return way;
}

/// A way without the motions of free bodies as wholes, and so without resultants of what joints press. Their momentum
/// is no more asked of supports either, of each in the measure of the impulse it had to bear.
VelocityUpdate::Way VelocityUpdate::within_bodies(Way way) const {
  const int dim = at_rest_.components();
  const auto momentum = spread_->bodies.remove_motion(way.velocity);
  way.at_points.clear();
  way.impulses = at_rest_.held().held_part(way.impulses, dim);
  std::vector<double> size(mass_.owned_nodes(), 0.0);
  double mine = 0;
  for (int n = 0; n < mass_.owned_nodes(); ++n) {
    for (int c = 0; c < dim; ++c) size[n] = std::hypot(size[n], way.impulses[dim * n + c]);
    mine += size[n];
  }
  const double all = total_over_ranks(*mass_.comm(), mine);
  for (int i = 0; all > 0 && i < dim * mass_.owned_nodes(); ++i)
    way.impulses[i] -= momentum[i % dim] * size[i / dim] / all;
  return way;
}

/// Ends the approach of closed points, and gives what this and the closing took back to what is behind them.
JumpImpulses VelocityUpdate::rebound(const Model& step, ContactState& state, const Impact& impact, double lost,
                                     double resting) {
  const auto& [speed, closed, apart] = impact;
  // A selection that changed on one rank changed for all.
  if (any_of_ranks(*mass_.comm(), !spread_ || spread_->apart != apart))
    spread_ = std::make_unique<Spread>(at_rest_, mass_, step, state, apart, solver_);
  auto& v = state.velocity;
  const auto supports = moving_supports(v);
  const double before = kinetic_energy(v);
  const auto given = v;
  auto [impulses, at_points] = project(v, closed, apart);
  const double wanted = lost + before - kinetic_energy(v) + work(impulses, supports);
  auto way = spread(step, state.lambda, speed, closed, resting);
  const double whole = kinetic_energy(way.velocity);
  if (!(whole > 0)) {
    v = given;  // the two sides hang together by other ties
    return {};
  }
  // Where closed points hold everything there is no way behind them: then they rebound.
  auto behind = within_bodies(way);
  auto ended = project(behind.velocity, closed, apart);
  add_impulses(behind.impulses, ended.of_supports);
  behind.at_points = std::move(ended.at_points);
  if (kinetic_energy(behind.velocity) > at_rest_.settings().internals.time_step.no_way * whole) way = std::move(behind);
  const double slope = product(v, way.velocity) - work(way.impulses, supports);
  const double change = least_change(kinetic_energy(way.velocity), slope, wanted);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += change * way.velocity[i];
  add_impulses(impulses, way.impulses, change);
  add_impulses(at_points, way.at_points, change);
  return {std::move(impulses), std::move(at_points)};
}

/// By how much the tangential impulses of friction are to change [N s]: to no more than their bound by what presses in
/// the end, and up to it at points that slip, as far as that does not stop their nodes.
PointField VelocityUpdate::to_the_pressure(const ContactState& state, const Impact& impact, const PointField& at_points,
                                           double acted) const {
  const int dim = at_rest_.components();
  PointField change(at_points.size(), 0.0);
  const auto speed = relative_velocities(at_rest_.points(), state.velocity);
  for (int k = 0; k < static_cast<int>(at_points.size()) / dim; ++k) {
    if (!impact.closed[dim * k] || !impact.apart[k] || at_points[dim * k] == 0) continue;
    double rubbed = 0, against = 0;
    for (int c = 1; c < dim; ++c) {
      rubbed = std::hypot(rubbed, acted * state.lambda[dim * k + c]);
      against -= acted * state.lambda[dim * k + c] * speed[dim * k + c];
    }
    const auto law = law_left(at_rest_, state, k);
    const double pressed = std::max(0.0, acted * state.lambda[dim * k] + at_points[dim * k]);
    const double bound = acted * law.cohesion + (pressed > 0 ? law.friction * pressed : 0.0);
    if (!(rubbed > 0) || !std::isfinite(bound)) continue;
    const bool slips = against > 0 && !sticks(at_rest_, state, k);
    const double stopped = slips ? projection_.mass(k, 1) * against / rubbed : 0.0;
    const double more = std::min(bound - rubbed, stopped);
    for (int c = 1; c < dim; ++c) change[dim * k + c] = more / rubbed * acted * state.lambda[dim * k + c];
  }
  return change;
}

VelocityJump VelocityUpdate::follow_the_pressure(ContactState& state, const Impact& impact, const PointField& at_points,
                                                 const Rubbed& rubbed) {
  const auto impulses = to_the_pressure(state, impact, at_points, rubbed.acted);
  const bool any = std::any_of(impulses.begin(), impulses.end(), [](double p) { return p != 0; });
  if (!any_of_ranks(*mass_.comm(), any)) return {};
  std::vector<double> change(state.velocity.size(), 0.0);
  VelocityJump jump;
  jump.impulses = projection_.push(change, impulses);
  // Of a share x of it the energy is linear x + square x^2: friction gives back no more than it took.
  const double linear = product(state.velocity, change) - work(jump.impulses, moving_supports(state.velocity));
  const double square = kinetic_energy(change);
  double share = 1;
  if (linear + square > rubbed.taken)
    share = 2 * rubbed.taken / (linear + std::sqrt(linear * linear + 4 * square * rubbed.taken));
  for (std::size_t i = 0; i < change.size(); ++i) state.velocity[i] += share * change[i];
  for (double& impulse : jump.impulses) impulse *= share;
  jump.friction = -share * (linear + share * square);
  return jump;
}

VelocityJump VelocityUpdate::apply(const Model& step, ContactState& state, double lost, double resting,
                                   const Rubbed& rubbed) {
  VOUSSOIR_EXPECT(is_of_nodes(at_rest_, state.velocity) && "velocity: of node copies");
  VOUSSOIR_EXPECT(std::isfinite(lost) && lost >= 0 && "energy of closing: not negative");
  VOUSSOIR_EXPECT(resting >= 0 && "resting speed: not negative");
  VOUSSOIR_EXPECT(rubbed.taken >= 0 && "energy of friction: not negative");
  const auto& points = at_rest_.points();
  const auto speed = relative_velocities(points, state.velocity);
  const auto [closed, sticking, apart] = contacts(at_rest_, state, speed, resting);
  auto by_friction = sticking;  // and by strength: what closing does not end
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i]) by_friction[i] = 0;
  auto& v = state.velocity;
  VelocityJump jump;
  if (fastest(speed, closed) > resting || lost > 0) {
    const Impact impact{speed, closed, apart};
    auto [of_supports, at_points] = rebound(step, state, impact, lost, resting);
    jump = follow_the_pressure(state, impact, at_points, rubbed);
    add_impulses(jump.impulses, of_supports);
  }
  if (fastest(relative_velocities(points, v), by_friction) <= resting) return jump;
  auto stopped = stop(v, sticking, apart);
  jump.friction += stopped.friction;
  add_impulses(jump.impulses, stopped.impulses);
  return jump;
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

VelocityJump VelocityUpdate::settle(ContactState& state, double resting) {
  if (!at_rest_.rubs()) return {};
  const auto speed = relative_velocities(at_rest_.points(), state.velocity);
  const auto at_points = contacts(at_rest_, state, speed, resting);
  return stop(state.velocity, at_points.sticking, at_points.apart);
}

}  // namespace voussoir
